#pragma once

#include <filesystem>
#include <string>

#include "app/request/command_options.h"
#include "base/messages/exit_code.h"

namespace clevis::app {

/// Options of `clevis picture`.
struct PictureOptions {
  std::filesystem::path result;  ///< folder of a check
  std::string part;              ///< empty: the mechanism
  std::filesystem::path file;    ///< empty: in the folder
};

/// Draws a result: its mechanism, or a part of it, as SVG.
/// @throws Error as read_result_folder(), I008 if it is no check or nothing
///   moves and no part is named, U001 for a file of another ending, S007, I002.
ExitCode picture_command(const PictureOptions& options);

/// Declares the options of `clevis picture`. @return what runs it.
Run declare_picture(CLI::App& command);

}  // namespace clevis::app
