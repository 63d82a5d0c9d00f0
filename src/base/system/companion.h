#pragma once

#include <filesystem>
#include <string>

namespace clevis {

/// The library with deal.II, PETSc and MPI, for any processor, and the same for
/// those with AVX2.
inline constexpr const char* kEngineLibrary = "clevis_engine.so";
inline constexpr const char* kEngineInLanes = "clevis_engine_avx2.so";

/// A file that belongs to clevis: beside the executable in the build tree, in
/// lib/clevis when installed.
std::filesystem::path companion(const std::string& name);

}  // namespace clevis
