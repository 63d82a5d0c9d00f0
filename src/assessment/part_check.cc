#include "assessment/part_check.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "assessment/beam_comparison.h"
#include "assessment/level.h"
#include "assessment/model_choice.h"
#include "assessment/verdict.h"
#include "base/errors.h"
#include "base/stopwatch.h"
#include "elasticity/stiffness.h"
#include "stress/deflection.h"
#include "stress/peak_band.h"

namespace clevis::assessment {
namespace {

constexpr int kHighestDegree = 4;
constexpr int kHighestSimplexDegree = 2;

PeakVerdict to_peak_verdict(stress::Convergence convergence) {
  switch (convergence) {
    case stress::Convergence::kConverged:
      return PeakVerdict::kConverged;
    case stress::Convergence::kSingular:
      return PeakVerdict::kSingular;
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
  return level.history.sampling_error +
         stress::time_sampling_error(
             level.history.peak.head(static_cast<Eigen::Index>(motion)));
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

template <int dim>
void fill_peak(const PartJob& job, const Level<dim>& level,
               const stress::Band& band, PeakStress& peak) {
  const auto& discretization = level.governing->discretization;
  const auto& history = level.history;
  peak.value = band.value;
  peak.band_low = band.low;
  peak.band_high = band.high;
  peak.verdict = to_peak_verdict(band.verdict);
  peak.at = stress::position<dim>(discretization, history.peak_at,
                                  history.subdivisions);
  peak.group = stress::surface_group<dim>(discretization, history.peak_at,
                                          history.subdivisions);
  const auto& instant =
      job.load_sets[level.set]
          .history.instants[static_cast<std::size_t>(history.peak_instant)];
  peak.instant = instant.time;
  peak.label = instant.label;
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
      *level.governing, job.part.material, level.history.subdivisions,
      level.history.peak_instant);
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
  fields.worst = level.history;
  fields.peak_instant = level.history.peak_instant;
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
PartAssessment run_ladder(const PartJob& job, const mesh::PartMesh<dim>& mesh,
                          const char* model) {
  PartAssessment assessment;
  PartResult& result = assessment.result;
  std::vector<SequenceMember>& sequence = result.peak.sequence;
  const int highest = mesh.shape == mesh::CellShape::kTensor
                          ? kHighestDegree
                          : kHighestSimplexDegree;
  std::vector<std::vector<double>> probes;  // per degree
  Level<dim> level;
  stress::Band band;
  // In 3-D three degrees up to 3 are cheaper than 4 alone.
  int degree = dim == 2 ? 2 : 1;
  while (degree < highest &&
         elasticity::folds<dim>(elasticity::discretize<dim>(mesh, degree))) {
    ++degree;
  }
  for (; degree <= highest; ++degree) {
    level = solve_level<dim>(job, mesh, degree, result.seconds);
    sequence.push_back(level.member);
    probes.push_back(level.probes);
    band = band_of(sequence, sampling_error(job, level), job.tolerance);
    if (sequence.size() > 2 &&
        band.verdict == stress::Convergence::kConverged) {
      break;
    }
  }
  result.model = fmt::format("{}, p = {}", model, level.member.degree);
  result.dofs = level.member.dofs;
  result.cells = static_cast<int>(mesh.cells.size());
  for (const auto& basis : level.bases) {
    result.load_columns += static_cast<int>(basis->columns.cols());
  }
  fill_peak<dim>(job, level, band, result.peak);
  fill_checks<dim>(level, result.self_checks);
  fill_probes(job, sequence, probes, result.probes);
  settle_even_pressure(check_reported_peak<dim>(job, level, result),
                       result.peak);
  fill_deflection<dim>(job, level, result);
  assessment.fields = make_fields<dim>(job, level);
  return assessment;
}

}  // namespace

PartAssessment check_part(const PartJob& job) {
  Stopwatch watch;
  PartAssessment assessment;
  const auto plate = plane_model(job);
  if (plate) {
    assessment = run_ladder<2>(job, *plate, "plane stress");
  } else {
    assessment = run_ladder<3>(
        job, job.mesh,
        job.mesh.shape == mesh::CellShape::kTensor ? "3-D" : "3-D tetrahedra");
  }
  PartResult& result = assessment.result;
  result.name = job.part.name;
  result.mass = job.mass.mass;
  result.safety_factor =
      result.peak.value > 0.0
          ? job.part.material.yield_strength / result.peak.value
          : 0.0;
  result.beam = compare_with_beam(job, result);
  judge(job.part, result);
  result.seconds.total = watch.lap();
  return assessment;
}

}  // namespace clevis::assessment
