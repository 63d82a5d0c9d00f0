#pragma once

#include <optional>
#include <vector>

#include "assessment/impact/struck_run.h"

namespace clevis::assessment {

/// A time for which a blow may be computed, and what comes after it.
struct BlowSpan {
  double duration{};  ///< [s]
  /// Largest after it over the largest until then, at least 1 [1].
  double stress = 1.0, deflection = 1.0, root = 1.0;

  /// But for what is not worth a longer time.
  bool holds_all() const {
    constexpr double kGrows = 1.01;
    return stress <= kGrows && deflection <= kGrows && root <= kGrows;
  }
};

/// Late response of a blow, after its default duration, by few shapes.
struct LateResponse {
  double looked_for{};  ///< [s]
  /// The given duration; else the default and twice and four times that, as
  /// far as later peaks are larger.
  std::vector<BlowSpan> spans;
  /// Bound of the free vibration of a part without damping over the largest
  /// until `looked_for`; else absent [1].
  std::optional<double> free_vibration_stress, free_vibration_deflection;
};

/// Late response of a blow, for twice its default or given duration, for
/// sixteen times where a force goes on pressing: a striker that bounces on an
/// undamped part may hit it as it swings back. Such a trajectory is chaotic:
/// its peaks have a range, its details mean nothing.
/// @param run  of the default or given duration, at this degree.
/// @param first_period  of the part [s].
template <int dim>
LateResponse late_response(const PartJob& job, const ImpactJob& impact,
                           const std::vector<stress::SingularZone>& zones,
                           int degree, const StruckRun<dim>& run,
                           double first_period, StruckFaces<dim>& faces);

}  // namespace clevis::assessment
