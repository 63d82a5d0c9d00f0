#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace clevis::report {

/// As zlib's format (RFC 1950), the same bytes for the same input.
std::vector<std::byte> compressed(std::span<const std::byte> bytes);

}  // namespace clevis::report
