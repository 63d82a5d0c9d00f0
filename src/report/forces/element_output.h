#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "report/summary/motion_report.h"
#include "report/text/terminal.h"

namespace clevis::report {

/// The forces that depend on the motion, one line per instant: coordinate,
/// rate, effort, friction, power of each.
std::string forces_csv(const MotionReport& report);

/// When contacts touch and let go, friction sticks and slips.
std::string events_csv(const MotionReport& report);

/// Peaks of each such force.
nlohmann::ordered_json forces_json(const MotionReport& report);
nlohmann::ordered_json events_json(const MotionReport& report);

/// Table of the peaks, and the first events; empty if there are neither.
std::string forces_text(const MotionReport& report, Colour colour);

}  // namespace clevis::report
