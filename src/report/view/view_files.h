#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/view/motion_view.h"
#include "report/view/part_view.h"

namespace clevis::report {

/// Origin of a folder's result.
enum class ResultKind { kCheck, kSimulation };

/// view/part_NAME.json; view/motion.json, of a simulation
/// view/simulation.json.
std::filesystem::path part_view_file(const std::filesystem::path& folder,
                                     const std::string& part);
std::filesystem::path motion_view_file(const std::filesystem::path& folder,
                                       ResultKind kind);

/// Writes them into the folder of a result.
/// @throws Error I002, F003 if a number is not finite.
void write_part_view(const PartView& view, const std::filesystem::path& folder);
void write_motion_view(const MotionView& view,
                       const std::filesystem::path& folder, ResultKind kind);

}  // namespace clevis::report
