#pragma once

#include <filesystem>

#include "app/request/command_options.h"
#include "base/messages/exit_code.h"

namespace clevis::app {

/// Options of `clevis import`.
struct ImportOptions {
  std::filesystem::path file;
  std::filesystem::path out;  ///< empty: the file's name without extension
};

/// Writes a model of another program as a scene into a new folder, with the
/// schema for editors, and prints what was lost or assumed.
/// @throws Error S013–S015 of the model; I005 if the folder is there and holds
///   anything; I002; what clevis refuses of the scene, which is there then.
ExitCode import_command(const ImportOptions& options);

/// Declares the options of `clevis import`. @return what runs it.
Run declare_import(CLI::App& command);

}  // namespace clevis::app
