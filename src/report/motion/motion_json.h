#pragma once

#include <string>

#include "report/summary/motion_report.h"

namespace clevis::report {

/// One JSON document: structure, summary, peaks, markers, closed form.
std::string motion_json(const MotionReport& report);

}  // namespace clevis::report
