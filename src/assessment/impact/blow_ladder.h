#pragma once

#include <optional>

#include "assessment/impact/response_scatter.h"
#include "assessment/impact/struck_run.h"
#include "assessment/models/fe_model.h"

namespace clevis::assessment {

/// When a blow is looked at.
struct BlowTimes {
  Eigen::VectorXd time;         ///< of all samples [s]
  std::vector<int> candidates;  ///< those at which peaks may stand, rising
  double error{};               ///< of steps and shapes [1]
  double front{};               ///< that is kept, of all degrees [s]
  double below{}, above{};      ///< error of the front [1]
  double root_below{}, root_above{};  ///< in the held sections [1]
  /// Largest stress after them over that at them, outside the zones and in the
  /// held sections [1].
  double later = 1.0, root_later = 1.0;
  std::optional<ResponseScatter> spread;  ///< that bands hold at the least

  int samples() const { return static_cast<int>(time.size()) - 1; }
};

/// Climbs the degrees with a blow in time, as check_part() does with loads at
/// rest: each degree moves on its own, peaks are those over all points and the
/// candidate samples, the fields those of the instants. The band has the error
/// of steps, shapes and front.
///
/// The error that the highest degree leaves may be above the tolerance, as
/// waves ask for more than loads at rest: up to a tenth the band is judged.
/// @param model  of loads at rest, with its error.
/// @param faces  of the model's mesh.
/// @throws Error of StruckFace.
template <int dim>
PartAssessment climb_blow(const PartJob& job, const ImpactJob& impact,
                          const BlowTimes& times, FeModel<dim> model,
                          StruckFaces<dim>& faces);

}  // namespace clevis::assessment
