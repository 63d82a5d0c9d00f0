#include "assessment/part_check.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "assessment/beam_comparison.h"
#include "assessment/level.h"
#include "assessment/model_choice.h"
#include "assessment/model_error.h"
#include "assessment/revolution_model.h"
#include "assessment/rung.h"
#include "assessment/verdict.h"
#include "assessment/zone_watch.h"
#include "base/errors.h"
#include "base/stopwatch.h"
#include "stress/deflection.h"
#include "stress/peak_band.h"

namespace clevis::assessment {
namespace {

PeakVerdict to_peak_verdict(stress::Convergence convergence) {
  switch (convergence) {
    case stress::Convergence::kConverged:
      return PeakVerdict::kConverged;
    // Growth alone is no proof: shape and supports show where it is due.
    case stress::Convergence::kSingular:
    case stress::Convergence::kNotConverged:
      break;
  }
  return PeakVerdict::kNotConverged;
}

/// What the peak may miss between the points of the lattice and between the
/// instants of the motion [Pa]. Cases stand behind the motion, at time 0.
template <int dim>
double sampling_error(const PartJob& job, const Level<dim>& level) {
  const auto& instants = job.load_sets[level.set].history.instants;
  std::size_t motion = 1;
  while (motion < instants.size() &&
         instants[motion].time > instants[motion - 1].time) {
    ++motion;
  }
  return level.history().sampling_error +
         stress::time_sampling_error(
             level.history().peak.head(static_cast<Eigen::Index>(motion)));
}

/// Band of the peak; what the samples may miss widens it upwards.
stress::Band band_of(const std::vector<SequenceMember>& sequence,
                     double sampling_error, double tolerance) {
  std::vector<stress::SequenceValue> values;
  for (const auto& member : sequence) {
    values.push_back({member.degree, member.peak});
  }
  stress::Band band = stress::peak_band(values, tolerance);
  band.high += sampling_error;
  if (band.verdict == stress::Convergence::kConverged &&
      band.high - band.value > tolerance * band.value) {
    band.verdict = stress::Convergence::kNotConverged;
  }
  return band;
}

/// Where a peak stands on the lattice of a load set.
struct PeakPlace {
  std::size_t set{};
  stress::FieldPoint at;
  int instant{};
};

template <int dim>
void fill_peak(const PartJob& job, const Level<dim>& level,
               const stress::Band& band, const PeakPlace& place,
               PeakStress& peak) {
  const auto& discretization = level.bases[place.set]->discretization;
  const int subdivisions = level.histories[place.set].subdivisions;
  peak.value = band.value;
  peak.band_low = band.low;
  peak.band_high = band.high;
  peak.verdict = to_peak_verdict(band.verdict);
  peak.at = stress::position<dim>(discretization, place.at, subdivisions);
  peak.group =
      stress::surface_group<dim>(discretization, place.at, subdivisions);
  const auto& instant =
      job.load_sets[place.set]
          .history.instants[static_cast<std::size_t>(place.instant)];
  peak.instant = instant.time;
  peak.label = instant.label;
}

/// Zones, and where one governs the peak away from those that do.
template <int dim>
void fill_zones(const PartJob& job, const Level<dim>& level,
                const ZoneWatch<dim>& zones, const stress::Band& outer_band,
                PartResult& result) {
  result.singular_zones = zones.results();
  if (!zones.is_singular()) return;
  result.peak.verdict = PeakVerdict::kSingular;
  const OutsidePeak& last = zones.outside().back();
  fill_peak<dim>(job, level, outer_band, {last.set, last.at, last.instant},
                 result.peak_outside);
  PeakStress& outside = result.peak_outside;
  outside.discretization_error = std::max(outside.band_high - outside.value,
                                          outside.value - outside.band_low);
  for (const OutsidePeak& peak : zones.outside()) {
    outside.sequence.push_back(peak.member);
  }
}

template <int dim>
stress::Band outer_band_of(const ZoneWatch<dim>& zones, double tolerance) {
  std::vector<SequenceMember> sequence;
  for (const auto& peak : zones.outside()) sequence.push_back(peak.member);
  return band_of(sequence, zones.outside().back().sampling_error, tolerance);
}

template <int dim>
void fill_deflection(const PartJob& job, const Level<dim>& level,
                     PartResult& result) {
  for (std::size_t s = 0; s < level.bases.size(); ++s) {
    const auto deflection = stress::largest_deflection<dim>(*level.bases[s]);
    result.strain_energy = std::max(result.strain_energy,
                                    level.bases[s]->strain_energy.maxCoeff());
    if (s > 0 && deflection.value <= result.deflection) continue;
    result.deflection = deflection.value;
    result.deflection_at = deflection.at;
    result.deflection_instant =
        job.load_sets[s]
            .history.instants[static_cast<std::size_t>(deflection.instant)]
            .time;
  }
}

template <int dim>
void fill_checks(const Level<dim>& level, SelfChecks& checks) {
  for (const auto& basis : level.bases) {
    checks.equilibrium = std::max(
        {checks.equilibrium, basis->checks.balance, basis->checks.equilibrium});
    checks.residual = std::max(checks.residual, basis->checks.residual);
    checks.energy = std::max(checks.energy, basis->checks.energy);
    checks.compression =
        std::max(checks.compression, basis->checks.compression);
  }
}

/// The field that is written, evaluated afresh, must have the reported peak
/// as its maximum.
/// @return the largest stress component at that instant [Pa].
template <int dim>
double check_reported_peak(const PartJob& job, const Level<dim>& level,
                           PartResult& result) {
  const auto field = stress::instant_field<dim>(
      *level.governing, job.part.material, level.history().subdivisions,
      level.history().peak_instant);
  double largest = 0.0;
  double component = 0.0;
  for (const auto& cell : field.stress) {
    largest = std::max(largest, stress::von_mises(cell).maxCoeff());
    component = std::max(component, cell.cwiseAbs().maxCoeff());
  }
  // Under even pressure von Mises is only the round-off of its components.
  const double round_off = 1e-12 * component;
  const double peak = result.peak.value;
  result.self_checks.reported_peak_is_field_maximum =
      std::isfinite(peak) &&
      std::abs(largest - peak) <= 1e-9 * peak + round_off;
  if (result.self_checks.reported_peak_is_field_maximum) return component;
  throw Error("F003", "part " + job.part.name,
              fmt::format("reported peak {:.6g} MPa, field maximum {:.6g} MPa",
                          peak / 1e6, largest / 1e6),
              "please report this scene");
}

/// Under even pressure von Mises is the round-off of K u and settles nowhere.
/// @param component  largest stress component [Pa].
void settle_even_pressure(double component, PeakStress& peak) {
  constexpr double kRoundOff = 1e-7;
  const double bound = kRoundOff * component;
  if (peak.value > bound || peak.verdict == PeakVerdict::kConverged) return;
  peak.verdict = PeakVerdict::kConverged;
  peak.band_low = 0.0;
  peak.band_high = bound;
}

template <int dim>
PartFields make_fields(const PartJob& job, const Level<dim>& level) {
  PartFields fields;
  fields.dim = dim;
  fields.shape = level.governing->discretization.shape;
  fields.worst = level.history();
  fields.peak_instant = level.history().peak_instant;
  for (const auto& instant : job.load_sets[level.set].history.instants) {
    fields.times.push_back(instant.time);
  }
  fields.at = [basis = level.governing, material = job.part.material](
                  int instant, int subdivisions) {
    return stress::instant_field<dim>(*basis, material, subdivisions, instant);
  };
  return fields;
}

/// Each probe with the band of its own sequence.
void fill_probes(const PartJob& job, const std::vector<SequenceMember>& degrees,
                 const std::vector<std::vector<double>>& values,
                 std::vector<ProbeResult>& results) {
  std::size_t index = 0;
  for (const auto& load_case : job.part.cases) {
    for (const auto& probe : load_case.probes) {
      std::vector<stress::SequenceValue> sequence;
      for (std::size_t k = 0; k < degrees.size(); ++k) {
        sequence.push_back({degrees[k].degree, values[k][index]});
      }
      const auto band = stress::peak_band(sequence, job.tolerance);
      results.push_back(
          {probe.name, probe.quantity, band.value, band.low, band.high});
      ++index;
    }
  }
}

template <int dim>
PartAssessment run_rung(const PartJob& job, const mesh::PartMesh<dim>& given,
                        const Rung<dim>& rung) {
  PartAssessment assessment;
  PartResult& result = assessment.result;
  std::vector<SequenceMember>& sequence = result.peak.sequence;
  std::vector<std::vector<double>> probes;  // per degree
  Level<dim> level;
  stress::Band band;
  stress::Band outer_band;
  ZoneWatch<dim> zones(job, given);
  const mesh::PartMesh<dim>& mesh = zones.mesh();
  const double tolerance = job.tolerance - rung.model_error;
  for (int degree = rung.first_degree; degree <= rung.highest_degree;
       ++degree) {
    try {
      level = solve_level<dim>(job, mesh, rung, degree, result.seconds);
    } catch (const Error& error) {
      // What the memory does not hold ends the sequence; three have a band.
      if (error.code() != "F004" || sequence.size() < 3) throw;
      break;
    }
    sequence.push_back(level.member);
    probes.push_back(level.probes);
    band = band_of(sequence, sampling_error(job, level), tolerance);
    zones.take(level);
    const bool singular = zones.is_singular();
    if (singular) outer_band = outer_band_of(zones, tolerance);
    if (sequence.size() > 2 && (singular ? outer_band : band).verdict ==
                                   stress::Convergence::kConverged) {
      break;
    }
  }
  result.model = fmt::format("{}, p = {}", rung.name, level.member.degree);
  result.dofs = level.member.dofs;
  result.cells = static_cast<int>(mesh.cells.size());
  for (const auto& basis : level.bases) {
    result.load_columns += static_cast<int>(basis->columns.cols());
  }
  const auto& history = level.history();
  fill_peak<dim>(job, level, band,
                 {level.set, history.peak_at, history.peak_instant},
                 result.peak);
  fill_zones<dim>(job, level, zones, outer_band, result);
  fill_checks<dim>(level, result.self_checks);
  fill_probes(job, sequence, probes, result.probes);
  settle_even_pressure(check_reported_peak<dim>(job, level, result),
                       result.peak);
  fill_deflection<dim>(job, level, result);
  assessment.fields = make_fields<dim>(job, level);
  assessment.fields.zones = zones.marks(level.set);
  return assessment;
}

/// Widens the band by the model's error and says what the rung has achieved.
void add_model_error(double tolerance, double model_error, PartResult& result) {
  PeakStress& peak = result.peak;
  peak.discretization_error =
      std::max(peak.band_high - peak.value, peak.value - peak.band_low);
  peak.model_error = model_error * peak.value;
  peak.band_low -= peak.model_error;
  peak.band_high += peak.model_error;
  const double half_width = peak.discretization_error + peak.model_error;
  if (peak.verdict == PeakVerdict::kConverged && model_error > 0.0 &&
      half_width > tolerance * peak.value) {
    peak.verdict = PeakVerdict::kNotConverged;
  }
  const auto percent = [&](double error) {
    return peak.value > 0.0 ? 100.0 * error / peak.value : 0.0;
  };
  result.stopped_because = fmt::format(
      "{}: {:.2g} % discretisation + {:.2g} % model, {:.3g} % wanted",
      peak.verdict == PeakVerdict::kConverged  ? "within tolerance"
      : peak.verdict == PeakVerdict::kSingular ? "stress without bound"
                                               : "highest degree done",
      percent(peak.discretization_error), percent(peak.model_error),
      100.0 * tolerance);
}

/// Whether a higher rung has nothing to add. Of a free part a slow sequence of
/// degrees that looks singular may only want a higher one.
bool is_settled(const PartJob& job, const PartResult& result) {
  const bool is_held =
      std::ranges::any_of(job.load_sets, [](const LoadSet& set) {
        return !set.fixed.empty();
      });
  return result.peak.verdict == PeakVerdict::kConverged ||
         (is_held && result.peak.verdict == PeakVerdict::kSingular);
}

void add_seconds(const PartSeconds& earlier, PartSeconds& seconds) {
  seconds.assemble += earlier.assemble;
  seconds.factor += earlier.factor;
  seconds.solve += earlier.solve;
  seconds.recover += earlier.recover;
}

PartAssessment run_plane_stress(const PartJob& job, const PlateModel& plate,
                                const std::vector<LoadSet>& governing) {
  auto assessment = run_rung<2>(job, plate.mesh, plane_stress_rung(plate.mesh));
  const bool measured =
      plate.mesh.shape == mesh::CellShape::kTensor &&
      assessment.result.peak.verdict != PeakVerdict::kSingular &&
      assessment.result.peak.value > 0.0;
  add_model_error(
      job.tolerance,
      measured ? plane_stress_error(job, plate.mesh, governing) : 0.0,
      assessment.result);
  if (!measured) assessment.result.stopped_because += "; model not measured";
  return assessment;
}

/// Looks closer where that is cheap or asked for.
int lattice_for(const PartJob& job) {
  constexpr double kFine = 0.005;
  constexpr std::size_t kFew = 10;
  std::size_t instants = 0;
  for (const LoadSet& set : job.load_sets) {
    instants += set.history.instants.size();
  }
  return instants <= kFew || job.tolerance < kFine ? 8 : 4;
}

/// Whether hexahedra can be solved: supports of the plane alone leave them
/// free to leave it.
bool is_held_in_space(const PartJob& job) {
  return std::ranges::all_of(job.load_sets, [](const LoadSet& set) {
    return set.fixed.empty() || std::ranges::any_of(set.fixed, [](auto& f) {
             return f.second[2];
           });
  });
}

PartAssessment run_layered(const PartJob& job, const PlateModel& plate,
                           const std::vector<LoadSet>& governing) {
  constexpr double kShare = 0.5;  // of the tolerance, for the model
  const auto choice =
      choose_terms(job, plate.mesh, governing, kShare * job.tolerance);
  auto rung = layered_rung(plate.mesh, choice.terms, lattice_for(job));
  rung.model_error = choice.model_error;
  auto assessment = run_rung<3>(job, job.mesh, rung);
  assessment.result.cells = static_cast<int>(plate.mesh.cells.size());
  add_model_error(job.tolerance, choice.model_error, assessment.result);
  return assessment;
}

PartAssessment run_revolution(const PartJob& job,
                              const mesh::Revolution& solid) {
  const auto progress = std::make_shared<RevolutionProgress>();
  auto assessment =
      run_rung<3>(job, job.mesh, revolution_rung(solid, progress));
  PartResult& result = assessment.result;
  result.model =
      fmt::format("axisymmetric, {} harmonic{}, p = {}", progress->harmonics,
                  progress->harmonics == 1 ? "" : "s", progress->degree);
  result.cells = static_cast<int>(solid.meridian.cells.size());
  add_model_error(job.tolerance, 0.0, result);
  if (result.peak.value > 0.0) {
    result.stopped_because += fmt::format(
        "; higher harmonics bring {:.2g} % at most, counted in the first",
        100.0 * progress->truncation / result.peak.value);
  }
  return assessment;
}

/// The lowest rung that meets the tolerance, or the highest that the part
/// and the job admit.
PartAssessment climb(const PartJob& job) {
  PartSeconds seconds;
  const auto solid = revolution_model(job);
  if (solid && job.model == ModelChoice::kRevolution) {
    return run_revolution(job, *solid);
  }
  const auto plate = plate_model(job);
  std::vector<LoadSet> governing;
  if (plate && plate->mesh.shape == mesh::CellShape::kTensor) {
    governing = governing_loads(job, plate->mesh, plate->suits_plane_stress);
  }
  if (plate && plate->suits_plane_stress &&
      job.model != ModelChoice::kLayered) {
    auto assessment = run_plane_stress(job, *plate, governing);
    const bool is_last = !plate->suits_layers && !is_held_in_space(job);
    if (is_settled(job, assessment.result) || is_last ||
        job.model == ModelChoice::kPlaneStress) {
      return assessment;
    }
    seconds = assessment.result.seconds;
  }
  if (plate && plate->suits_layers) {
    auto assessment = run_layered(job, *plate, governing);
    add_seconds(seconds, assessment.result.seconds);
    const PeakStress& peak = assessment.result.peak;
    // Where the degree falls short hexahedra of the same mesh do too.
    if (is_settled(job, assessment.result) ||
        job.model == ModelChoice::kLayered || !is_held_in_space(job) ||
        peak.verdict == PeakVerdict::kSingular ||
        peak.model_error < job.tolerance * peak.value) {
      return assessment;
    }
    seconds = assessment.result.seconds;
  }
  if (solid) {
    auto assessment = run_revolution(job, *solid);
    add_seconds(seconds, assessment.result.seconds);
    return assessment;
  }
  auto assessment = run_rung<3>(job, job.mesh, solid_rung(job.mesh));
  add_seconds(seconds, assessment.result.seconds);
  add_model_error(job.tolerance, 0.0, assessment.result);
  return assessment;
}

}  // namespace

PartAssessment check_part(const PartJob& job) {
  Stopwatch watch;
  PartAssessment assessment = climb(job);
  PartResult& result = assessment.result;
  result.name = job.part.name;
  result.mass = job.mass.mass;
  const double judged = judged_peak(result).value;
  result.safety_factor =
      judged > 0.0 ? job.part.material.yield_strength / judged : 0.0;
  result.beam = compare_with_beam(job, result);
  judge(job.part, result);
  result.seconds.total = watch.lap();
  return assessment;
}

}  // namespace clevis::assessment
