#include "assessment/impact_check.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>

#include "assessment/verdict.h"
#include "base/errors.h"
#include "base/stopwatch.h"
#include "beam/struck_part.h"
#include "elasticity/eigenmodes.h"
#include "elasticity/strike_response.h"
#include "stress/singular_zone.h"
#include "stress/stress_history.h"
#include "stress/zone_mask.h"

namespace clevis::assessment {
namespace {

using dynamics::Route;
using Eigen::Vector3d;

constexpr int kSubdivisions = 2;
constexpr const char* kPublished = "beam, published";
constexpr double kTimeTolerance = 3e-3;
constexpr double kDirectTolerance = 3e-2;  // it only checks the other route
constexpr int kSamples = 1200;
// Blows of a part up to which every one is computed by both routes.
constexpr std::size_t kCrossChecked = 4;

const loads::GroupGeometry& group_of(const PartJob& job,
                                     const std::string& name) {
  const auto found =
      std::ranges::find(job.groups, name, &loads::GroupGeometry::name);
  if (found != job.groups.end()) return *found;
  throw Error("M003", "part " + job.part.name,
              fmt::format("the mesh has no group \"{}\"", name),
              "Name a physical group of the mesh.");
}

/// The blow as a static case of a force along its direction.
part::LoadCaseDefinition static_case(const PartJob& job,
                                     const ImpactJob& impact, double force) {
  part::LoadCaseDefinition load_case;
  load_case.name = impact.strike.name;
  load_case.traction[impact.strike.group] =
      force / group_of(job, impact.strike.group).area * impact.strike.direction;
  load_case.fixed = impact.fixed;
  return load_case;
}

/// F_eq: what at rest deflects a spring without mass as the blow does.
double equivalent_force(const loads::Strike& strike, double stiffness) {
  return strike.force +
         std::sqrt(strike.force * strike.force +
                   stiffness * strike.mass * strike.speed * strike.speed);
}

/// Largest von Mises outside the singular zones.
double judged_stress(const elasticity::DisplacementBasis<3>& basis,
                     const PartJob& job,
                     const std::vector<stress::SingularZone>& zones) {
  const auto history =
      stress::stress_history<3>(basis, job.part.material, kSubdivisions);
  const auto zone_of =
      stress::zone_of_points<3>(basis.discretization, kSubdivisions, zones);
  return stress::peak_outside(history, zone_of,
                              std::vector<bool>(zones.size(), true), 3)
      .value;
}

/// By how much the stress may be higher between the samples: a third of what
/// every second sample loses [1].
double sampling_error(const elasticity::DisplacementBasis<3>& basis,
                      const PartJob& job,
                      const std::vector<stress::SingularZone>& zones,
                      double stress) {
  elasticity::DisplacementBasis<3> half;
  half.discretization = basis.discretization;
  half.columns = basis.columns;
  const Eigen::Index count = (basis.coefficients.cols() + 1) / 2;
  half.coefficients.resize(basis.coefficients.rows(), count);
  for (Eigen::Index i = 0; i < count; ++i) {
    half.coefficients.col(i) = basis.coefficients.col(2 * i);
  }
  half.strain_energy.setZero(count);
  return (1.0 - judged_stress(half, job, zones) / stress) / 3.0;
}

/// One blow by one route and degree.
struct DynamicRun {
  elasticity::StrikeResponse<3> response;
  double stress{};          ///< [Pa]
  double static_stress{};   ///< by the static force of 1 N [Pa]
  double sampling_error{};  ///< of the stress [1]
  double factor{};          ///< of F_eq, with the elements' stiffness [1]
  double seconds{}, static_seconds{};
};

DynamicRun run(const PartJob& job, const ImpactJob& impact,
               const std::vector<stress::SingularZone>& zones, int degree,
               Route route) {
  const auto unit = loads::case_loads(job.part, static_case(job, impact, 1.0),
                                      job.groups, job.mass);
  const elasticity::ElasticProblem<3> problem{job.mesh, job.part.material, unit,
                                              impact.fixed, job.part.name};
  dynamics::StrikeOptions options;
  options.route = route;
  options.tolerance =
      route == Route::kDirect ? kDirectTolerance : kTimeTolerance;
  options.samples = kSamples;
  Stopwatch watch;
  DynamicRun found{.response = elasticity::solve_strike<3>(
                       problem, impact.strike, degree, options)};
  found.stress = judged_stress(found.response.basis, job, zones);
  found.seconds = watch.lap();
  found.sampling_error =
      sampling_error(found.response.basis, job, zones, found.stress);
  watch.lap();
  found.static_stress =
      judged_stress(elasticity::solve<3>(problem, degree), job, zones);
  found.static_seconds = watch.lap();
  found.factor = found.stress /
                 (found.static_stress *
                  equivalent_force(impact.strike, found.response.stiffness));
  return found;
}

double error_in_time(const DynamicRun& run) {
  return run.response.solution.error() + run.sampling_error;
}

std::optional<beam::BarOfPart> bar_of(const PartJob& job,
                                      const ImpactJob& impact) {
  if (impact.fixed.size() != 1) return std::nullopt;
  const auto& [root, held] = *impact.fixed.begin();
  if (!(held[0] && held[1] && held[2])) return std::nullopt;
  return beam::bar_of_part(
      job.mesh, job.part.material, job.mass.mass, group_of(job, root).centroid,
      group_of(job, impact.strike.group).centroid, impact.strike.direction);
}

/// The published model takes twice the speed and a third of the stiffness.
void add_beam_rows(const beam::BarOfPart& bar, const loads::Strike& strike,
                   std::vector<ImpactRow>& rows) {
  const beam::Blow blow{
      .mass = strike.mass, .speed = strike.speed, .force = strike.force};
  beam::Blow twice = blow;
  twice.speed *= 2.0;
  const auto add = [&rows](const char* model, auto compute) {
    Stopwatch watch;
    const beam::BarImpact found = compute();
    rows.push_back({.model = model,
                    .nominal = found.stress,
                    .deflection = found.deflection,
                    .seconds = watch.lap()});
  };
  add(kPublished, [&] {
    return beam::impact(bar.published, twice);
  });
  add("beam, corrected", [&] {
    return beam::impact(bar.bar, blow);
  });
  add("beam, corrected, its mass moving along", [&] {
    return beam::impact(bar.bar, blow, beam::StruckMass::kMovesAlong);
  });
}

double beam_factor(const beam::BarOfPart& bar, const loads::Strike& strike) {
  return beam::impact(bar.bar, {.mass = strike.mass,
                                .speed = strike.speed,
                                .force = strike.force})
      .factor.value_or(0.0);
}

ImpactRow dynamic_row(const DynamicRun& run, int degree, double nominal,
                      double error) {
  const auto& solution = run.response.solution;
  return {.model = fmt::format("dynamic elements, {}, p = {}",
                               solution.is_modal
                                   ? fmt::format("{} shapes", solution.modes)
                                   : fmt::format("{} steps", solution.steps),
                               degree),
          .stress = run.stress,
          .nominal = nominal,
          .deflection = run.response.motion().peak_contact,
          .error = error,
          .seconds = run.seconds};
}

std::string percent(double part) {
  return fmt::format("{:.2g} %", 100.0 * std::abs(part));
}

/// Which side a model is on, and why.
std::string remark_on(const ImpactRow& row, const ImpactResult& impact,
                      double deflection, double part_stiffness) {
  constexpr double kEqual = 0.02, kClose = 0.10;
  const double off = row.ratio - 1.0;
  std::string text = std::abs(off) < kEqual ? "agrees"
                     : off < 0.0            ? "unsafe by " + percent(off)
                                            : "safe by " + percent(off);
  const double bent = row.deflection / deflection;
  if (bent > 1.0 + kClose || bent < 1.0 - kClose) {
    text += fmt::format(", deflection {:.2f} times", bent);
  }
  if (row.model == kPublished) {
    return text + ": twice the speed on a third of the stiffness";
  }
  if (off < -kEqual) {
    text += fmt::format(
        ": higher modes, mass ratio {:.2g}, load for {:.2g} first periods",
        impact.mass / impact.part_mass,
        impact.load_duration / impact.first_period);
  } else if (off > kEqual && impact.exponent == 1.0 &&
             impact.stiffness < 10.0 * part_stiffness) {
    text += fmt::format(
        ": the contact, {:.2g} times as stiff as the part, takes its share",
        impact.stiffness / part_stiffness);
  } else if (off > kEqual) {
    text += fmt::format(
        ": part of the energy goes into the part's own motion, "
        "mass ratio {:.2g}",
        impact.mass / impact.part_mass);
  }
  return text;
}

void note_motion(const DynamicRun& best, ImpactResult& impact) {
  const auto& run = best.response.motion();
  impact.peak_force = run.peak_force;
  impact.rise_time = run.peak_force_time;
  impact.load_duration = run.release_time >= 0.0
                             ? run.release_time
                             : run.time[run.time.size() - 1];
  impact.deflection = run.peak_contact;
  impact.dynamic_factor = best.factor;
  impact.reason = best.response.solution.reason;
}

struct Computed {
  ImpactResult result;
  double force{};  ///< static, that stresses as much [N]
};

Computed compute(const PartJob& job, const ImpactJob& impact) {
  const bool simplex = job.mesh.shape == mesh::CellShape::kSimplex;
  const int low = simplex ? 1 : 2, high = low + 1;
  const auto zones =
      stress::singular_zones<3>(job.mesh, job.part.material, impact.fixed);
  const DynamicRun coarse = run(job, impact, zones, low, Route::kAuto);
  std::optional<DynamicRun> direct;
  if (job.impacts.size() <= kCrossChecked) {
    direct = run(job, impact, zones, low, Route::kDirect);
  }
  const DynamicRun fine = run(job, impact, zones, high, Route::kAuto);
  Computed found;
  ImpactResult& result = found.result;
  result.name = impact.strike.name;
  result.source = impact.source;
  result.mass = impact.strike.mass;
  result.speed = impact.strike.speed;
  result.force = impact.strike.force;
  result.stiffness = impact.strike.contact.stiffness;
  result.exponent = impact.strike.contact.exponent;
  result.part_mass = fine.response.mass;
  const auto unit = loads::case_loads(job.part, static_case(job, impact, 1.0),
                                      job.groups, job.mass);
  result.first_period = elasticity::first_period<3>(
      {job.mesh, job.part.material, unit, impact.fixed, job.part.name}, low);
  note_motion(fine, result);
  const double stiffness = fine.response.stiffness;
  const double force = equivalent_force(impact.strike, stiffness);
  found.force = fine.factor * force;

  const auto bar = bar_of(job, impact);
  if (bar) {
    add_beam_rows(*bar, impact.strike, result.rows);
    result.beam_factor = beam_factor(*bar, impact.strike);
  }
  // stress over that at rest, times beam theory's at rest: what a strain
  // gauge away from the clamp makes of the root's moment
  const auto nominal = [&](const DynamicRun& run) {
    return bar ? run.stress / run.static_stress * bar->bar.stress_per_force
               : 0.0;
  };
  const double space = std::abs(coarse.factor / fine.factor - 1.0);
  result.rows.push_back(
      {.model = fmt::format("static elements x factor, p = {}", high),
       .stress = force * fine.static_stress,
       .nominal = bar ? force * bar->bar.stress_per_force : 0.0,
       .deflection = force / stiffness,
       .error = std::abs(coarse.static_stress / fine.static_stress - 1.0),
       .seconds = fine.static_seconds});
  const double coarse_error = std::abs(coarse.stress / fine.stress - 1.0);
  if (direct) {
    result.rows.push_back(dynamic_row(*direct, low, nominal(*direct),
                                      coarse_error + error_in_time(*direct)));
  }
  result.rows.push_back(dynamic_row(coarse, low, nominal(coarse),
                                    coarse_error + error_in_time(coarse)));
  result.rows.push_back(
      dynamic_row(fine, high, nominal(fine), space + error_in_time(fine)));
  for (ImpactRow& row : result.rows) {
    row.ratio = bar ? row.nominal / nominal(fine) : row.stress / fine.stress;
    row.remark = remark_on(row, result, result.deflection, stiffness);
  }
  result.rows.back().remark = "judged";
  // for finish_impacts(): the factor's own error
  result.stress = fine.stress;
  result.band_low = fine.stress * (1.0 - result.rows.back().error);
  result.band_high = fine.stress * (1.0 + result.rows.back().error);
  return found;
}

}  // namespace

std::vector<ImpactResult> compute_impacts(PartJob& job) {
  std::vector<ImpactResult> impacts;
  for (const ImpactJob& impact : job.impacts) {
    Computed found = compute(job, impact);
    const auto load_case = static_case(job, impact, found.force);
    job.load_sets.push_back(
        {loads::case_loads(job.part, load_case, job.groups, job.mass),
         impact.fixed});
    impacts.push_back(std::move(found.result));
  }
  return impacts;
}

void finish_impacts(const PartJob& job, std::vector<ImpactResult> impacts,
                    PartResult& result) {
  const bool only_blow = impacts.size() == 1 && job.load_sets.size() == 1;
  double worst = 0.0;
  for (ImpactResult& impact : impacts) {
    const double error = impact.rows.back().error;
    worst = std::max(worst, error);
    if (only_blow) {
      // the ladder's stress has its own band; the factor's error comes on top
      const PeakStress& judged = judged_peak(result);
      impact.stress = judged.value;
      impact.band_low = judged.band_low - error * judged.value;
      impact.band_high = judged.band_high + error * judged.value;
    }
    impact.safety_factor = job.part.material.yield_strength / impact.stress;
  }
  for (PeakStress* peak : {&result.peak, &result.peak_outside}) {
    peak->band_low -= worst * peak->value;
    peak->band_high += worst * peak->value;
    peak->model_error += worst * peak->value;
  }
  if (!impacts.empty()) {
    result.first_period = impacts.front().first_period;
    result.deflection = std::max(
        result.deflection,
        std::ranges::max_element(impacts, {}, &ImpactResult::deflection)
            ->deflection);
  }
  result.impacts = std::move(impacts);
}

double half_sine_amplification(double r) {
  constexpr double kPi = std::numbers::pi;
  if (!(r > 0.0)) return 0.0;
  // a mode of period 1 under sin(π t/r) up to r; then it swings freely
  const double a = 0.5 / r;  // ratio of frequencies
  if (std::abs(a - 1.0) < 1e-9) return 0.5 * kPi;
  const double scale = 1.0 / (1.0 - a * a);
  const auto at = [&](double t) {
    return scale * (std::sin(kPi * t / r) - a * std::sin(2.0 * kPi * t));
  };
  double largest = 0.0;
  constexpr int kTimes = 20000;
  for (int i = 0; i <= kTimes; ++i) {
    largest = std::max(largest, std::abs(at(r * i / kTimes)));
  }
  const double rate = scale * (kPi / r * std::cos(kPi) -
                               2.0 * kPi * a * std::cos(2.0 * kPi * r));
  return std::max(largest, std::hypot(at(r), rate / (2.0 * kPi)));
}

double pulse_amplification(double duration_over_period,
                           double rise_over_period) {
  constexpr double kLopsided = 0.4;  // of the duration; of a half sine 0.5
  const double half_sine = half_sine_amplification(duration_over_period);
  if (rise_over_period > kLopsided * duration_over_period ||
      duration_over_period < 0.5) {
    return half_sine;
  }
  const double step =
      1.0 + std::min(1.0, 1.0 / (std::numbers::pi * rise_over_period));
  return std::max(half_sine, step);
}

void judge_paces(const PartJob& job, PartResult& result) {
  if (job.impact_loads.empty()) return;
  constexpr double kSlow = 0.10, kShort = 0.25;
  const loads::LoadHistory none;
  result.first_period = elasticity::first_period<3>(
      {job.mesh, job.part.material, none, {}, job.part.name},
      job.mesh.shape == mesh::CellShape::kSimplex ? 1 : 2);
  for (const ImpactLoad& load : job.impact_loads) {
    LoadPace pace;
    pace.impact = load.name;
    pace.duration = load.duration;
    pace.rise_time = load.rise_time;
    pace.ratio = load.duration / result.first_period;
    pace.amplification =
        pulse_amplification(pace.ratio, load.rise_time / result.first_period);
    pace.treatment =
        pace.ratio < kShort
            ? "beam impact: over before the part gives way, the loads of the "
              "instants are an upper bound"
        : pace.amplification <= 1.0 + kSlow
            ? "quasi-static: the loads of the instants suffice"
            : "dynamic elements: the loads of the instants may be exceeded";
    result.paces.push_back(pace);
  }
}

}  // namespace clevis::assessment
