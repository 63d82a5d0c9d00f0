#pragma once

#include <filesystem>
#include <string>

namespace clevis {

/// The library with deal.II, PETSc and MPI.
inline constexpr const char* kEngineLibrary = "clevis_engine.so";

/// A file that belongs to clevis: beside the executable in the build tree, in
/// lib/clevis when installed.
std::filesystem::path companion(const std::string& name);

}  // namespace clevis
