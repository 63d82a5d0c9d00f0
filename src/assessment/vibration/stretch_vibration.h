#pragma once

#include <vector>

#include "assessment/job/part_job.h"
#include "assessment/job/part_result.h"
#include "assessment/vibration/vibrating_model.h"

namespace clevis::assessment {

/// A stretch of the loads' motion, and the times that are looked at.
struct Stretch {
  double hold_time{};  ///< LoadHistory::hold_time [s]
  VibrationTimes times;
};

/// The vibration of the stretch that stresses the part most, with the largest
/// deflection of all. Without a ratio where the model refuses: `failure`.
/// @param job  of one load set. @param stretches  not empty.
VibrationResult largest_vibration(const PartJob& job,
                                  const std::vector<Stretch>& stretches);

}  // namespace clevis::assessment
