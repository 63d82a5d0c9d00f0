#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>

/// One input of a reader that users feed: reads it, and lets nothing through
/// but a clevis::Error. Linked with libFuzzer, or with replay.cc.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size);

namespace clevis::testing {

/// The input as a file, the same at each call; gone with the process.
/// @param name  of the file, with the ending that readers look at.
std::filesystem::path as_file(const std::uint8_t* data, std::size_t size,
                              const char* name);

}  // namespace clevis::testing
