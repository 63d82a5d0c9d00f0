#include "assessment/struck_run.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/errors.h"
#include "base/stopwatch.h"
#include "stress/stress_history.h"
#include "stress/zone_mask.h"

namespace clevis::assessment {
namespace {

using dynamics::Route;

constexpr int kSubdivisions = 2;
constexpr double kTimeTolerance = 3e-3;
constexpr double kDirectTolerance = 3e-2;  // it only checks the other route

elasticity::DisplacementBasis<3> every_second(
    const elasticity::DisplacementBasis<3>& basis) {
  elasticity::DisplacementBasis<3> half;
  half.discretization = basis.discretization;
  half.columns = basis.columns;
  const Eigen::Index count = (basis.coefficients.cols() + 1) / 2;
  half.coefficients.resize(basis.coefficients.rows(), count);
  for (Eigen::Index i = 0; i < count; ++i) {
    half.coefficients.col(i) = basis.coefficients.col(2 * i);
  }
  half.strain_energy.setZero(count);
  return half;
}

/// What a face's matrices depend on beside the part and the degree.
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

elasticity::StruckFace<3>& StruckFaces::get(const PartJob& job,
                                            const ImpactJob& impact,
                                            int degree) {
  Entry& entry = of_degree_[degree];
  const std::string key = face_key(impact);
  if (!entry.face || entry.key != key) {
    entry.face.reset();
    const loads::LoadHistory none;
    entry.face = std::make_unique<elasticity::StruckFace<3>>(
        elasticity::ElasticProblem<3>{job.mesh, job.part.material, none,
                                      impact.fixed, job.part.name},
        impact.strike.group, impact.strike.direction, degree);
    entry.key = key;
  }
  return *entry.face;
}

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

StruckRun run_struck(const PartJob& job, const ImpactJob& impact,
                     const std::vector<stress::SingularZone>& zones, int degree,
                     Route route, StruckFaces& faces) {
  const auto unit = loads::case_loads(job.part, static_case(job, impact, 1.0),
                                      job.groups, job.mass);
  const elasticity::ElasticProblem<3> problem{job.mesh, job.part.material, unit,
                                              impact.fixed, job.part.name};
  dynamics::StrikeOptions options;
  options.route = route;
  options.tolerance =
      route == Route::kDirect ? kDirectTolerance : kTimeTolerance;
  options.samples = kBlowSamples;
  Stopwatch watch;
  StruckRun found{
      .response = faces.get(job, impact, degree).solve(impact.strike, options)};
  found.stress = judged_stress(found.response.basis, job, zones);
  found.seconds = watch.lap();
  found.deflection = stress::largest_deflection<3>(found.response.basis);
  // between the samples: a third of what every second one loses
  const auto half = every_second(found.response.basis);
  found.sampling_error =
      (1.0 - judged_stress(half, job, zones) / found.stress) / 3.0;
  found.deflection_sampling =
      (found.deflection.value - stress::largest_deflection<3>(half).value) /
      3.0;
  watch.lap();
  const auto at_rest = elasticity::solve<3>(problem, degree);
  found.static_stress = judged_stress(at_rest, job, zones);
  found.static_deflection = stress::largest_deflection<3>(at_rest).value;
  found.static_seconds = watch.lap();
  found.factor = found.stress /
                 (found.static_stress *
                  equivalent_force(impact.strike, found.response.stiffness));
  return found;
}

}  // namespace clevis::assessment
