#pragma once

#include <filesystem>

namespace clevis::support {

/// Top folder of the sources that are tested. A function of a library of its
/// own, not a macro: no other object then depends on where the clone stands,
/// and the compiler cache serves every clone.
std::filesystem::path source_dir();

}  // namespace clevis::support
