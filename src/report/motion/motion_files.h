#pragma once

#include <filesystem>

#include "report/summary/motion_report.h"

namespace clevis::report {

/// Writes reactions.csv, motion.csv, with forces that depend on the motion
/// forces.csv and events.csv, with bearings bearings.csv, and, last,
/// simulate.json into `folder`.
/// @throws Error I002; F003 if a number is not finite.
void write_motion_files(const MotionReport& report,
                        const std::filesystem::path& folder);

}  // namespace clevis::report
