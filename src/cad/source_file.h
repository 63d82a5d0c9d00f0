#pragma once

#include <filesystem>

#include "part/solid_source.h"

namespace clevis::cad {

/// Refuses a file that does not begin as its extension promises, before any
/// library sees it: a script under the name of a STEP file is never run.
/// @throws Error I001 if it cannot be read, M015 if it is something else or
///   larger than 256 MiB.
void require_solid_file(const std::filesystem::path& file);

}  // namespace clevis::cad
