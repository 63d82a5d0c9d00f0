#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace clevis::report {

/// A picture as PNG, written fast rather than small.
/// @param rgb  three bytes a pixel, row by row from the top.
/// @throws Error X001 if libpng refuses it.
std::string png_of(const std::vector<std::uint8_t>& rgb, int width, int height);

}  // namespace clevis::report
