#pragma once

#include <filesystem>

namespace clevis::multibody {

/// Refuses a file that cannot be SDF or URDF, before any library sees it.
/// @throws Error I001 if it cannot be read, S013 if it does not begin as XML
///   does or is larger than 16 MiB.
void require_model_file(const std::filesystem::path& file);

}  // namespace clevis::multibody
