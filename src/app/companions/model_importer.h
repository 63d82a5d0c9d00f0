#pragma once

#include <filesystem>

#include "multibody/model.h"

namespace clevis::app {

/// The program's name, beside clevis or in lib/clevis.
inline constexpr const char* kImporter = "clevis-importer";

/// Reads an SDF or URDF file by clevis-importer, a child process with limits.
/// It opens no other file than this.
/// @throws Error I001, S013 of the file's head; as the importer refuses; S014
///   if it takes more than 8 s or 2 GiB, or dies.
multibody::Model run_importer(const std::filesystem::path& file,
                              const std::filesystem::path& program = {});

}  // namespace clevis::app
