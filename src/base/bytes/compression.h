#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace clevis {

enum class Effort { kFast, kUsual };

/// As zlib's format (RFC 1950), the same bytes for the same input.
std::vector<std::byte> compressed(std::span<const std::byte> bytes,
                                  Effort effort = Effort::kUsual);

}  // namespace clevis
