#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace clevis::stress {

/// A <DataArray> of a VTU file: compressed by zlib as one block, in base 64.
/// @param attributes  after its type, e.g. `Name="types"`.
std::string vtu_array(std::span<const float> values,
                      const std::string& attributes);
std::string vtu_array(std::span<const std::int32_t> values,
                      const std::string& attributes);
std::string vtu_array(std::span<const std::uint8_t> values,
                      const std::string& attributes);

}  // namespace clevis::stress
