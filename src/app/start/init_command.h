#pragma once

#include <filesystem>
#include <string>

#include "app/request/command_options.h"
#include "base/messages/exit_code.h"

namespace clevis::app {

/// Options of `clevis init`.
struct InitOptions {
  std::filesystem::path folder;
  std::string template_word = "part";
  std::filesystem::path geometry;  ///< a solid instead of a template
};

/// Writes a commented scene that runs, its geometry and the schema for editors
/// into a new folder.
/// @throws Error I005 if the folder is there and holds anything, I002; U001 if
///   it is called as a CAD file; those of geometry_scene().
ExitCode init_command(const InitOptions& options);

/// Declares the options of `clevis init`. @return what runs it.
Run declare_init(CLI::App& command);

}  // namespace clevis::app
