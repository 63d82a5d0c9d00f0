#include "assessment/impact/struck_run.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/messages/errors.h"
#include "base/values/stopwatch.h"
#include "elasticity/solid/solid_solve.h"
#include "loads/parts/case_loads.h"
#include "stress/field/stress_history.h"
#include "stress/zones/zone_mask.h"

namespace clevis::assessment {
namespace {

using dynamics::Route;

constexpr int kSubdivisions = 2;
constexpr double kTimeTolerance = 3e-3;
constexpr double kDirectTolerance = 3e-2;  // it only checks the other route

template <int dim>
elasticity::DisplacementBasis<dim> every_second(
    const elasticity::DisplacementBasis<dim>& basis) {
  std::vector<int> samples;
  for (int i = 0; i < basis.coefficients.cols(); i += 2) samples.push_back(i);
  return at_samples(basis, samples);
}

/// Stresses of a run on the lattice, and where they count.
struct Lattice {
  stress::StressHistory history;
  Eigen::MatrixXi zone_of;
  stress::PartialPeak peak;  ///< outside the zones
};

template <int dim>
Lattice look_at(const elasticity::DisplacementBasis<dim>& basis,
                const PartJob& job,
                const std::vector<stress::SingularZone>& zones) {
  Lattice found;
  found.history =
      stress::stress_history<dim>(basis, job.part.material, kSubdivisions);
  found.zone_of =
      stress::zone_of_points<dim>(basis.discretization, kSubdivisions, zones);
  found.peak = stress::peak_outside(found.history, found.zone_of,
                                    std::vector<bool>(zones.size(), true), dim);
  return found;
}

/// The samples beside those at which points of high stress have their worst,
/// beside the largest stress of all and those given; between them every
/// twelfth.
std::vector<int> candidate_samples(const Lattice& found,
                                   const std::vector<int>& more) {
  constexpr double kHigh = 0.8;
  constexpr int kBeside = 3, kElse = 12;
  const auto count = static_cast<int>(found.history.peak.size());
  std::vector<bool> kept(static_cast<std::size_t>(count), false);
  const auto keep = [&](int at) {
    for (int i = std::max(0, at - kBeside);
         i <= std::min(count - 1, at + kBeside); ++i) {
      kept[static_cast<std::size_t>(i)] = true;
    }
  };
  for (Eigen::Index c = 0; c < found.zone_of.cols(); ++c) {
    for (Eigen::Index q = 0; q < found.zone_of.rows(); ++q) {
      if (found.zone_of(q, c) < 0 &&
          found.history.worst(q, c) >= kHigh * found.peak.value) {
        keep(found.history.worst_instant(q, c));
      }
    }
  }
  keep(found.history.peak_instant);
  for (const int at : more) keep(at);
  std::vector<int> samples;
  for (int i = 0; i < count; ++i) {
    if (kept[static_cast<std::size_t>(i)] || i % kElse == 0) {
      samples.push_back(i);
    }
  }
  return samples;
}

/// Key of a face's matrices beside the part and the degree.
std::string face_key(const ImpactJob& impact) {
  const auto& d = impact.strike.direction;
  std::string key = fmt::format("{}|{:a}|{:a}|{:a}", impact.strike.group, d.x(),
                                d.y(), d.z());
  for (const auto& [group, held] : impact.fixed) {
    key += fmt::format("|{}|{}{}{}", group, held[0], held[1], held[2]);
  }
  return key;
}

}  // namespace

dynamics::StrikeOptions strike_options(const PartJob& job, Route route,
                                       const ImpactJob& impact) {
  dynamics::StrikeOptions options;
  options.route = route;
  options.tolerance =
      route == Route::kDirect ? kDirectTolerance : kTimeTolerance;
  options.samples = impact.samples;
  options.modal_damping = job.part.damping;
  if (route != Route::kDirect && impact.front > 0.0) {
    options.damping = dynamics::Damping::kFronts;
    options.wave_front_time = impact.front;
  }
  return options;
}

template <int dim>
elasticity::StruckFace<dim>& StruckFaces<dim>::get(const PartJob& job,
                                                   const ImpactJob& impact,
                                                   int degree) {
  Entry& entry = of_degree_[degree];
  const std::string key = face_key(impact);
  if (!entry.face || entry.key != key) {
    entry.face.reset();
    const loads::LoadHistory none;
    entry.face = std::make_unique<elasticity::StruckFace<dim>>(
        elasticity::ElasticProblem<dim>{.mesh = mesh_,
                                        .material = job.part.material,
                                        .history = none,
                                        .fixed = impact.fixed,
                                        .name = job.part.name,
                                        .max_dofs = job.max_dofs},
        impact.strike.group, impact.strike.direction, degree);
    entry.key = key;
  }
  return *entry.face;
}

template <int dim>
elasticity::DisplacementBasis<dim> at_samples(
    const elasticity::DisplacementBasis<dim>& basis,
    const std::vector<int>& samples) {
  elasticity::DisplacementBasis<dim> some;
  some.discretization = basis.discretization;
  some.equations = basis.equations;
  some.columns = basis.columns;
  some.coefficients = basis.coefficients(Eigen::all, samples);
  some.strain_energy = basis.strain_energy(samples);
  some.checks = basis.checks;
  some.seconds = basis.seconds;
  return some;
}

template <int dim>
double judged_stress(const elasticity::DisplacementBasis<dim>& basis,
                     const PartJob& job,
                     const std::vector<stress::SingularZone>& zones) {
  return look_at(basis, job, zones).peak.value;
}

template <int dim>
Eigen::VectorXd judged_peaks(const elasticity::DisplacementBasis<dim>& basis,
                             const PartJob& job,
                             const std::vector<stress::SingularZone>& zones) {
  return stress::peaks_outside<dim>(
      basis, job.part.material, kSubdivisions,
      stress::zone_of_points<dim>(basis.discretization, kSubdivisions, zones));
}

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

template <int dim>
SupportPeak support_peak(const elasticity::DisplacementBasis<dim>& basis,
                         const PartJob& job, const ImpactJob& impact) {
  SupportPeak peak;
  for (const auto& face : stress::support_faces<dim>(
           basis, job.part.material, impact.fixed, {}, job.part.name)) {
    if (peak.of_sample.size() == 0) peak.of_sample = face.nominal;
    peak.of_sample = peak.of_sample.cwiseMax(face.nominal);
    Eigen::Index at = 0;
    const double value = face.nominal.maxCoeff(&at);
    if (value <= peak.value) continue;
    peak.value = value;
    peak.sample = static_cast<int>(at);
    peak.name = face.name;
  }
  return peak;
}

template <int dim>
StruckRun<dim> run_struck(const PartJob& job, const ImpactJob& impact,
                          const std::vector<stress::SingularZone>& zones,
                          int degree, Route route, StruckFaces<dim>& faces) {
  const auto unit = loads::case_loads(job.part, static_case(job, impact, 1.0),
                                      job.groups, job.mass);
  const elasticity::ElasticProblem<dim> problem{
      faces.mesh(), job.part.material, unit, impact.fixed, job.part.name};
  Stopwatch watch;
  StruckRun<dim> found;
  found.response =
      faces.get(job, impact, degree)
          .solve(impact.strike, strike_options(job, route, impact));
  const auto& basis = found.response.basis;
  const Lattice looked = look_at(basis, job, zones);
  found.stress = looked.peak.value;
  found.seconds = watch.lap();
  found.deflection = stress::largest_deflection<dim>(basis);
  found.root = support_peak(basis, job, impact);
  found.candidates =
      candidate_samples(looked, {found.deflection.instant, found.root.sample});
  // between the samples: a third of what every second one loses
  const auto half = every_second(basis);
  found.sampling_error =
      (1.0 - judged_stress(half, job, zones) / found.stress) / 3.0;
  found.deflection_sampling =
      (found.deflection.value - stress::largest_deflection<dim>(half).value) /
      3.0;
  watch.lap();
  const auto at_rest = elasticity::solve<dim>(problem, degree);
  found.static_stress = judged_stress(at_rest, job, zones);
  found.static_root = support_peak(at_rest, job, impact).value;
  found.static_deflection = stress::largest_deflection<dim>(at_rest).value;
  found.static_seconds = watch.lap();
  found.factor = found.stress /
                 (found.static_stress *
                  equivalent_force(impact.strike, found.response.stiffness));
  return found;
}

#define CLEVIS_INSTANTIATE(dim)                                            \
  template class StruckFaces<dim>;                                         \
  template SupportPeak support_peak<dim>(                                  \
      const elasticity::DisplacementBasis<dim>&, const PartJob&,           \
      const ImpactJob&);                                                   \
  template elasticity::DisplacementBasis<dim> at_samples<dim>(             \
      const elasticity::DisplacementBasis<dim>&, const std::vector<int>&); \
  template double judged_stress<dim>(                                      \
      const elasticity::DisplacementBasis<dim>&, const PartJob&,           \
      const std::vector<stress::SingularZone>&);                           \
  template Eigen::VectorXd judged_peaks<dim>(                              \
      const elasticity::DisplacementBasis<dim>&, const PartJob&,           \
      const std::vector<stress::SingularZone>&);                           \
  template StruckRun<dim> run_struck<dim>(                                 \
      const PartJob&, const ImpactJob&,                                    \
      const std::vector<stress::SingularZone>&, int, Route,                \
      StruckFaces<dim>&);
CLEVIS_INSTANTIATE(2)
CLEVIS_INSTANTIATE(3)

}  // namespace clevis::assessment
