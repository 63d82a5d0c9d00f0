#pragma once

#include <vector>

#include <Eigen/Core>

#include "assessment/job/part_job.h"

namespace clevis::assessment {

/// A stretch of the motion in which a part vibrates most.
struct VibrationWindow {
  double from{}, to{};  ///< [s]
};

/// Those that meet or overlap as one; rising.
std::vector<VibrationWindow> joined(std::vector<VibrationWindow> all);

/// What lies in both, rising. @param a, b  rising.
std::vector<VibrationWindow> in_both(const std::vector<VibrationWindow>& a,
                                     const std::vector<VibrationWindow>& b);

/// Of all windows [s].
double total_duration(const std::vector<VibrationWindow>& windows);

/// Times that are nearer to an instant than to others.
VibrationWindow nearest_times(const std::vector<loads::InstantLoad>& instants,
                              std::size_t i);

/// From a first period before each onset until five after it. Joined where they
/// meet, within the motion.
/// @param onsets  rising [s]. @param period  first [s].
/// @param motion  from its first instant to its last.
std::vector<VibrationWindow> vibration_windows(
    const std::vector<double>& onsets, double period,
    const VibrationWindow& motion);

/// Each window and what follows until the part's swing has fallen to a
/// twentieth, a hundred first periods at most; joined, until `end` [s].
/// @param period  first [s]. @param damping  ζ [1].
std::vector<VibrationWindow> swing_windows(
    const std::vector<VibrationWindow>& windows, double period, double damping,
    double end);

bool lies_in(const std::vector<VibrationWindow>& windows, double time);

/// Instants of the motion in the windows.
std::vector<Eigen::Index> instants_within(
    const std::vector<VibrationWindow>& windows,
    const std::vector<loads::InstantLoad>& instants);

/// Even times in the windows, one every `step` [s] but so many in all at most;
/// rising.
Eigen::VectorXd times_within(const std::vector<VibrationWindow>& windows,
                             double step, int most);

/// Times beside the highest of those in the windows at which the peak stress
/// tops its neighbours', eight to an interval; rising [s].
/// @param time, peak  of times that were looked at [s], [Pa].
/// @param most  of the highest.
Eigen::VectorXd times_near_peaks(const Eigen::VectorXd& time,
                                 const Eigen::VectorXd& peak,
                                 const std::vector<VibrationWindow>& windows,
                                 std::size_t most);

/// Both, rising, none twice.
Eigen::VectorXd merged(const Eigen::VectorXd& a, const Eigen::VectorXd& b);

}  // namespace clevis::assessment
