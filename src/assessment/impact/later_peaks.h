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

  bool holds_all() const {
    return stress == 1.0 && deflection == 1.0 && root == 1.0;
  }
};

/// What a blow does after its default duration, by few shapes.
struct LaterPeaks {
  double looked_for{};  ///< [s]
  /// The given duration; else the default and twice and four times that, as
  /// far as later peaks are larger.
  std::vector<BlowSpan> spans;
  /// Of a part that swings freely without damping: what it comes to at the
  /// most, whenever, over the largest until `looked_for`; else absent [1].
  std::optional<double> swing_stress, swing_deflection;
};

/// Follows a blow for twice its default or given duration, where a force goes
/// on pressing for sixteen times: a striker that bounces on an undamped part
/// may hit it when it comes towards it. Such a course depends on its beginning
/// so much that it cannot be told in detail, its peaks can.
/// @param run  of the default or given duration, at this degree.
/// @param first_period  of the part [s].
template <int dim>
LaterPeaks look_later(const PartJob& job, const ImpactJob& impact,
                      const std::vector<stress::SingularZone>& zones,
                      int degree, const StruckRun<dim>& run,
                      double first_period, StruckFaces<dim>& faces);

}  // namespace clevis::assessment
