#pragma once

#include <vector>

#include "assessment/job/part_job.h"

namespace clevis::assessment {

/// The loads over the motion of the part's body, without its cases.
LoadSet motion_loads(const PartJob& job);

/// Instants closer than this part of the motion are the two sides of an event
/// [1].
inline constexpr double kEventSides = 1e-8;

/// An event at which the loads of a part jump.
struct LoadJump {
  double time{};   ///< [s]
  double stays{};  ///< until the next jump or the motion's end [s]
  /// What a mode that follows a force or moment swings to without damping,
  /// beyond the force after the jump by the jump, over the largest at any
  /// instant [1].
  double reach{};
};

/// Where a force or moment of the motion jumps by more than 2 % of the largest.
std::vector<LoadJump> load_jumps(const PartJob& job);

}  // namespace clevis::assessment
