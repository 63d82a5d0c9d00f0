#pragma once

#include <filesystem>

#include "app/request/options.h"
#include "base/messages/errors.h"
#include "scene/scene.h"

namespace clevis::app {

/// Loads the library of the commands that solve.
/// @return its path.
/// @throws Error I001 if it is missing or lacks a library of its own.
std::filesystem::path load_plugin();

/// Reads the scene (scene_to_solve), loads the library and runs one of its
/// commands.
/// @throws Error I001 if the library is missing, X001 if it is another
///   version's.
ExitCode run_in_plugin(const char* entry_name, const Options& options);

/// Gives the scene's bodies the compliance of their parts.
/// @throws Error as run_in_plugin() and add_link_compliances().
void add_link_compliances_by_plugin(scene::Scene& scene);

}  // namespace clevis::app
