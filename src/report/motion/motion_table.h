#pragma once

#include <string>

#include "report/summary/motion_report.h"
#include "report/text/terminal.h"

namespace clevis::report {

/// Table of `clevis simulate`: structure, quality of the motion, peak
/// reactions, drives, paths of the markers, closed form.
std::string motion_table(const MotionReport& report, Colour colour);

}  // namespace clevis::report
