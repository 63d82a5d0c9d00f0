#include "assessment/front_refinement.h"

#include <cmath>

namespace clevis::assessment {

template <int dim>
bool is_hard(const StruckRun<dim>& run) {
  constexpr int kManyShapes = 100;
  const auto& solution = run.response.solution;
  return solution.is_ideal || solution.damping_time > 0.0 ||
         solution.modes > kManyShapes;
}

template <int dim>
FrontRefinement refine_front(const PartJob& job, const ImpactJob& impact,
                             const std::vector<stress::SingularZone>& zones,
                             int degree, double ideal_spring,
                             StruckFaces<dim>& faces) {
  constexpr double kTolerance = 3e-2, kStiffer = 4.0;
  dynamics::StrikeOptions options;
  options.route = dynamics::Route::kModal;
  options.damping = dynamics::Damping::kFronts;
  options.tolerance = kTolerance;
  options.samples = kBlowSamples;
  FrontRefinement found;
  auto& face = faces.get(job, impact, degree);
  loads::Strike strike = impact.strike;
  double stiffness = ideal_spring;
  for (const int vectors : {64, 128, 256}) {
    options.front_modes = vectors;
    if (!std::isfinite(impact.strike.contact.stiffness)) {
      strike.contact.stiffness = stiffness;
      stiffness *= kStiffer;
    }
    const auto response = face.solve(strike, options);
    found.fronts.push_back(response.solution.damping_time);
    found.stress.push_back(judged_stress(response.basis, job, zones));
    found.deflection.push_back(response.motion().peak_contact);
  }
  found.settles = !dynamics::grows_with_refinement(found.stress);
  return found;
}

template bool is_hard<2>(const StruckRun<2>&);
template bool is_hard<3>(const StruckRun<3>&);
template FrontRefinement refine_front<2>(
    const PartJob&, const ImpactJob&, const std::vector<stress::SingularZone>&,
    int, double, StruckFaces<2>&);
template FrontRefinement refine_front<3>(
    const PartJob&, const ImpactJob&, const std::vector<stress::SingularZone>&,
    int, double, StruckFaces<3>&);

}  // namespace clevis::assessment
