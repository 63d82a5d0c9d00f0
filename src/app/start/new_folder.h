#pragma once

#include <filesystem>

namespace clevis::app {

/// A command that makes a folder overwrites nothing.
/// @throws Error I005 if `folder` is there and not an empty folder.
void require_new_folder(const std::filesystem::path& folder);

}  // namespace clevis::app
