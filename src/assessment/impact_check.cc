#include "assessment/impact_check.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "assessment/front_refinement.h"
#include "assessment/impact_rows.h"
#include "assessment/struck_run.h"
#include "assessment/verdict.h"
#include "elasticity/eigenmodes.h"

namespace clevis::assessment {
namespace {

using dynamics::Route;

// Blows of a part up to which every one that is not hard is computed by both
// routes.
constexpr std::size_t kCrossChecked = 4;

/// @param space  error of the elements [1].
void note_deflection(const StruckRun& best, double space,
                     ImpactResult& impact) {
  impact.deflection = best.deflection.value;
  impact.deflection_at = best.deflection.at;
  impact.deflection_time = best.response.motion().time[best.deflection.instant];
  impact.deflection_error =
      best.deflection_sampling +
      (space + best.response.solution.error()) * best.deflection.value;
}

void note_motion(const StruckRun& best, ImpactResult& impact) {
  const auto& run = best.response.motion();
  impact.peak_force = run.peak_force;
  impact.rise_time = run.peak_force_time;
  impact.load_duration = run.release_time >= 0.0
                             ? run.release_time
                             : run.time[run.time.size() - 1];
  impact.dynamic_factor = best.factor;
  impact.reason = best.response.solution.reason;
}

struct Computed {
  ImpactResult result;
  double force{};  ///< static, that stresses as much [N]
};

/// Whether a duration that was given ends while the striker presses and the
/// worst may be to come.
bool ends_too_soon(const loads::Strike& strike,
                   const dynamics::StrikeRun& run) {
  constexpr double kLate = 0.9;
  if (!strike.duration || run.release_time >= 0.0) return false;
  const double late = kLate * *strike.duration;
  return strike.force == 0.0 || run.peak_contact_time > late ||
         run.peak_force_time > late;
}

Computed compute(const PartJob& job, const ImpactJob& impact,
                 StruckFaces& faces) {
  const bool simplex = job.mesh.shape == mesh::CellShape::kSimplex;
  const int low = simplex ? 1 : 2, high = low + 1;
  const auto zones =
      stress::singular_zones<3>(job.mesh, job.part.material, impact.fixed);
  const StruckRun coarse =
      run_struck(job, impact, zones, low, Route::kAuto, faces);
  std::optional<StruckRun> direct;
  if (job.impacts.size() <= kCrossChecked && !is_hard(coarse)) {
    direct = run_struck(job, impact, zones, low, Route::kDirect, faces);
  }
  const StruckRun fine =
      run_struck(job, impact, zones, high, Route::kAuto, faces);
  Computed found;
  ImpactResult& result = found.result;
  if (is_hard(fine)) {
    result.refinement =
        refine_front(job, impact, zones, high,
                     fine.response.solution.contact_stiffness, faces);
  }
  result.name = impact.strike.name;
  result.source = impact.source;
  result.mass = impact.strike.mass;
  result.speed = impact.strike.speed;
  result.force = impact.strike.force;
  result.stiffness = fine.response.solution.contact_stiffness;
  result.is_ideal = fine.response.solution.is_ideal;
  result.exponent = impact.strike.contact.exponent;
  result.part_mass = fine.response.mass;
  const auto unit = loads::case_loads(job.part, static_case(job, impact, 1.0),
                                      job.groups, job.mass);
  result.first_period = elasticity::first_period<3>(
      {job.mesh, job.part.material, unit, impact.fixed, job.part.name}, low);
  note_motion(fine, result);
  note_deflection(
      fine, std::abs(coarse.deflection.value / fine.deflection.value - 1.0),
      result);
  result.is_cut = ends_too_soon(impact.strike, fine.response.motion());
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
  const auto nominal = [&](const StruckRun& run) {
    return bar ? run.stress / run.static_stress * bar->bar.stress_per_force
               : 0.0;
  };
  const double space = std::abs(coarse.factor / fine.factor - 1.0);
  result.rows.push_back(
      {.model = fmt::format("static elements x factor, p = {}", high),
       .stress = force * fine.static_stress,
       .nominal = bar ? force * bar->bar.stress_per_force : 0.0,
       .face = force / stiffness,
       .deflection = force * fine.static_deflection,
       .error = std::abs(coarse.static_stress / fine.static_stress - 1.0),
       .seconds = fine.static_seconds});
  const double coarse_error = std::abs(coarse.stress / fine.stress - 1.0);
  if (direct) {
    result.rows.push_back(struck_row(*direct, low, nominal(*direct),
                                     coarse_error + direct->error_in_time()));
  }
  result.rows.push_back(struck_row(coarse, low, nominal(coarse),
                                   coarse_error + coarse.error_in_time()));
  result.rows.push_back(
      struck_row(fine, high, nominal(fine), space + fine.error_in_time()));
  for (ImpactRow& row : result.rows) {
    row.ratio = bar ? row.nominal / nominal(fine) : row.stress / fine.stress;
    row.remark =
        remark_on(row, result, fine.response.motion().peak_contact, stiffness);
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
  StruckFaces faces;
  for (const ImpactJob& impact : job.impacts) {
    Computed found = compute(job, impact, faces);
    const auto load_case = static_case(job, impact, found.force);
    job.load_sets.push_back(
        {loads::case_loads(job.part, load_case, job.groups, job.mass),
         impact.fixed});
    impacts.push_back(std::move(found.result));
  }
  return impacts;
}

namespace {

/// That of the blows in time; beside loads at rest the larger.
void take_deflection(const PartJob& job,
                     const std::vector<ImpactResult>& impacts,
                     PartResult& result) {
  const ImpactResult& worst =
      *std::ranges::max_element(impacts, {}, &ImpactResult::deflection);
  const bool only_blows = job.load_sets.size() == impacts.size();
  if (!only_blows && result.deflection > worst.deflection) return;
  result.deflection = worst.deflection;
  result.deflection_error = worst.deflection_error;
  result.deflection_at = worst.deflection_at;
  result.deflection_instant = worst.deflection_time;
}

}  // namespace

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
  const bool unsettled =
      std::ranges::any_of(impacts, [](const ImpactResult& i) {
        return !i.refinement.settles || i.is_cut;
      });
  for (PeakStress* peak : {&result.peak, &result.peak_outside}) {
    if (unsettled && peak->verdict == PeakVerdict::kConverged) {
      peak->verdict = PeakVerdict::kNotConverged;
    }
    peak->band_low -= worst * peak->value;
    peak->band_high += worst * peak->value;
    peak->model_error += worst * peak->value;
  }
  if (!impacts.empty()) {
    result.first_period = impacts.front().first_period;
    take_deflection(job, impacts, result);
  }
  result.impacts = std::move(impacts);
}

}  // namespace clevis::assessment
