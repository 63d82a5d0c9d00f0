#pragma once

#include <vector>

#include "assessment/job/part_job.h"

namespace clevis::assessment {

/// The loads over the motion of the part's body, without its cases.
LoadSet motion_loads(const PartJob& job);

/// An event at which the loads of a part jump.
struct LoadJump {
  double time{};   ///< [s]
  double stays{};  ///< until the next jump or the motion's end [s]
  /// What a mode that follows a component of a force or moment swings to
  /// without damping, beyond its value after the jump by the jump, over the
  /// component's largest at any instant [1].
  double reach{};
};

/// Where a component of a force or moment of the motion jumps by more than 2 %
/// of its largest. Each counts by itself, for a small force across a part may
/// stress it more than a large one along it; below a thousandth of the largest
/// none does.
std::vector<LoadJump> load_jumps(const PartJob& job);

}  // namespace clevis::assessment
