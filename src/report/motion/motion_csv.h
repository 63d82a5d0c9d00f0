#pragma once

#include <string>

#include "report/summary/motion_report.h"

namespace clevis::report {

/// Every joint at every instant: what it does to body b, in W and in the
/// frame of b, and what it does to a in the frame of a. Without the efforts of
/// drives, which stand in motion.csv.
std::string reactions_csv(const MotionReport& report);

/// One line per instant: pose, velocity, acceleration of every body, the
/// markers and the drives.
std::string motion_csv(const MotionReport& report);

}  // namespace clevis::report
