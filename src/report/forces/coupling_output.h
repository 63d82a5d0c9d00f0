#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "report/summary/motion_report.h"
#include "report/text/terminal.h"

namespace clevis::report {

/// Efforts of gears and racks on their first coordinate.
nlohmann::ordered_json couplings_json(const MotionReport& report);

/// The same as a table; empty without couplings.
std::string couplings_text(const MotionReport& report, Colour colour);

}  // namespace clevis::report
