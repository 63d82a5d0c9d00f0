#include "assessment/part_check.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "assessment/verdict.h"
#include "base/errors.h"
#include "beam/beam_estimate.h"
#include "elasticity/displacement_basis.h"
#include "elasticity/load_vectors.h"
#include "mesh/mesh_reader.h"
#include "stress/deflection.h"
#include "stress/peak_band.h"

namespace clevis::assessment {
namespace {

using elasticity::DisplacementBasis;

constexpr int kHighestDegree = 4;
constexpr int kHighestSimplexDegree = 2;

/// Lattice on which the peak is sought: the same for every degree, so that
/// the sequence compares like with like. In a straight tetrahedron of degree
/// 2 the stress is linear, so its von Mises peaks at a corner.
template <int dim>
int lattice_subdivisions(mesh::CellShape shape) {
  if (shape == mesh::CellShape::kSimplex) return 1;
  return dim == 2 ? 8 : 4;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start)
      .count();
}

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

/// One degree: all load sets solved, the governing one kept.
template <int dim>
struct Level {
  std::shared_ptr<DisplacementBasis<dim>> governing;
  std::vector<std::shared_ptr<DisplacementBasis<dim>>> bases;  ///< per set
  stress::StressHistory history;
  std::size_t set{};
  SequenceMember member;
};

template <int dim>
Level<dim> solve_level(const PartJob& job, const mesh::PartMesh<dim>& mesh,
                       int degree, PartSeconds& seconds) {
  Level<dim> level;
  for (std::size_t s = 0; s < job.load_sets.size(); ++s) {
    const LoadSet& set = job.load_sets[s];
    auto basis =
        std::make_shared<DisplacementBasis<dim>>(elasticity::solve<dim>(
            {mesh, job.part.material, set.history, set.fixed, job.part.name},
            degree));
    seconds.assemble += basis->seconds.assemble;
    seconds.factor += basis->seconds.factor;
    seconds.solve += basis->seconds.solve;
    const auto start = std::chrono::steady_clock::now();
    auto history = stress::stress_history<dim>(
        *basis, job.part.material, lattice_subdivisions<dim>(mesh.shape));
    seconds.recover += seconds_since(start);
    level.bases.push_back(basis);
    if (level.governing && history.largest() <= level.history.largest()) {
      continue;
    }
    level.governing = basis;
    level.history = std::move(history);
    level.set = s;
  }
  level.member.degree = degree;
  level.member.dofs = level.governing->discretization.dofs();
  level.member.peak = level.history.largest();
  level.member.strain_energy =
      level.governing->strain_energy[level.history.peak_instant];
  return level;
}

/// Band of the peak; what the lattice may miss widens it upwards.
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

/// Surfaces of the first two seats that the deflection refers to.
std::vector<std::string> reference_groups(const LoadSet& set) {
  std::vector<std::string> groups;
  if (!set.fixed.empty()) return groups;
  for (const auto& seat : set.history.seats) {
    if (seat.kind == loads::SeatKind::kBearing && groups.size() < 2) {
      groups.push_back(seat.group);
    }
  }
  return groups;
}

template <int dim>
void fill_deflection(const PartJob& job, const Level<dim>& level,
                     PartResult& result) {
  for (std::size_t s = 0; s < level.bases.size(); ++s) {
    stress::remove_rigid_motion<dim>(*level.bases[s],
                                     reference_groups(job.load_sets[s]));
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
template <int dim>
void check_reported_peak(const PartJob& job, const Level<dim>& level,
                         PartResult& result) {
  const auto field = stress::instant_field<dim>(
      *level.governing, job.part.material, level.history.subdivisions,
      level.history.peak_instant);
  double largest = 0.0;
  for (const auto& cell : field.stress) {
    largest = std::max(largest, stress::von_mises(cell).maxCoeff());
  }
  const double peak = result.peak.value;
  result.self_checks.reported_peak_is_field_maximum =
      std::isfinite(peak) && std::abs(largest - peak) <= 1e-9 * peak;
  if (result.self_checks.reported_peak_is_field_maximum) return;
  throw Error("F003", "part " + job.part.name,
              fmt::format("reported peak {:.6g} MPa, field maximum {:.6g} MPa",
                          peak / 1e6, largest / 1e6),
              "please report this scene");
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

template <int dim>
PartAssessment run_ladder(const PartJob& job, const mesh::PartMesh<dim>& mesh,
                          const char* model) {
  PartAssessment assessment;
  PartResult& result = assessment.result;
  std::vector<SequenceMember>& sequence = result.peak.sequence;
  const int highest = mesh.shape == mesh::CellShape::kTensor
                          ? kHighestDegree
                          : kHighestSimplexDegree;
  Level<dim> level;
  stress::Band band;
  // In 3-D three degrees up to 3 are cheaper than 4 alone.
  for (int degree = dim == 2 ? 2 : 1; degree <= highest; ++degree) {
    level = solve_level<dim>(job, mesh, degree, result.seconds);
    sequence.push_back(level.member);
    band = band_of(sequence, level.history.sampling_error, job.tolerance);
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
  check_reported_peak<dim>(job, level, result);
  fill_deflection<dim>(job, level, result);
  assessment.fields = make_fields<dim>(job, level);
  return assessment;
}

void fill_beam(const PartJob& job, PartResult& result) {
  BeamComparison& comparison = result.beam;
  for (const LoadSet& set : job.load_sets) {
    const auto estimate =
        beam::estimate(job.mesh, job.part.material, job.mass, job.groups,
                       set.history, job.buckling_length);
    if (!estimate.stresses.empty() &&
        estimate.stresses.front().stress > comparison.peak_stress) {
      comparison.peak_stress = estimate.stresses.front().stress;
      comparison.governing = estimate.stresses.front().formula + ", " +
                             estimate.stresses.front().where;
    }
    comparison.deflection =
        std::max(comparison.deflection, estimate.deflection);
    if (estimate.buckling_safety > 0.0 &&
        (comparison.buckling_safety == 0.0 ||
         estimate.buckling_safety < comparison.buckling_safety)) {
      comparison.buckling_safety = estimate.buckling_safety;
    }
  }
  if (comparison.peak_stress > 0.0) {
    comparison.ratio_fe_to_beam = result.peak.value / comparison.peak_stress;
  }
  comparison.reason = explain_ratio(result);
}

bool has_groups(const mesh::PartMesh<2>& plate, const PartJob& job) {
  const auto known = [&](const std::string& name) {
    const auto found =
        std::ranges::find(plate.groups, name, &mesh::SurfaceGroup::name);
    if (found == plate.groups.end()) return false;
    const auto index = static_cast<int>(found - plate.groups.begin());
    return std::ranges::any_of(plate.boundary, [&](const auto& face) {
      return face.group == index;
    });
  };
  return std::ranges::all_of(job.load_sets, [&](const LoadSet& set) {
    const bool in_plane =
        elasticity::loads_in_plane(set.history, plate.mid_plane_z);
    return in_plane &&
           std::ranges::all_of(set.history.seats,
                               [&](const auto& s) {
                                 return known(s.group);
                               }) &&
           std::ranges::all_of(set.history.instants.front().surface_loads,
                               [&](const auto& s) {
                                 return known(s.group);
                               }) &&
           std::ranges::all_of(set.fixed, [&](const auto& f) {
             return known(f.first);
           });
  });
}

}  // namespace

PartAssessment check_part(const PartJob& job) {
  const auto start = std::chrono::steady_clock::now();
  PartAssessment assessment;
  std::optional<mesh::PartMesh<2>> plate;
  if (job.model != ModelChoice::kSolid) {
    plate = mesh::plate_mid_plane(job.mesh);
    if (plate && !has_groups(*plate, job)) plate.reset();
  }
  if (!plate && job.model == ModelChoice::kPlaneStress) {
    throw Error("F005", "part " + job.part.name,
                "the part is no plate along z that is loaded in its plane",
                "leave --model out");
  }
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
  fill_beam(job, result);
  judge(job.part, result);
  result.seconds.total = seconds_since(start);
  return assessment;
}

}  // namespace clevis::assessment
