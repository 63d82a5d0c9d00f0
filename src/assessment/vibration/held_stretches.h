#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "assessment/job/part_job.h"
#include "assessment/vibration/vibration_times.h"

namespace clevis::assessment {

/// Stretches of a motion through which slides hold a part at like places.
struct HeldStretch {
  double hold_time{};  ///< at which they are in the middle of these [s]
  std::vector<VibrationWindow> windows;
  double period{};  ///< first, with what the mechanism holds and adds [s]
};

/// How the mechanism holds a part through the motions of its load sets; worked
/// out when it is asked for first.
class HeldMotions {
 public:
  /// @param job  outlives the object.
  explicit HeldMotions(const PartJob& job)
      : job_(job), stretches_(job.load_sets.size()) {}

  /// Of all of followed_loads(); one, at the history's own hold_time, where no
  /// slide that holds the part travels or its first period does not change by
  /// that.
  const std::vector<HeldStretch>& stretches(std::size_t set);
  /// Longest first period of its stretches [s].
  double first_period(std::size_t set);

 private:
  const PartJob& job_;
  std::vector<std::optional<std::vector<HeldStretch>>> stretches_;
};

/// What lies in both, rising. @param a, b  rising.
std::vector<VibrationWindow> in_both(const std::vector<VibrationWindow>& a,
                                     const std::vector<VibrationWindow>& b);

}  // namespace clevis::assessment
