#pragma once

#include <concepts>
#include <cstddef>

namespace clevis {

/// A number that counts from 0 as an index of the standard containers.
/// @pre i >= 0.
constexpr std::size_t index(std::integral auto i) {
  return static_cast<std::size_t>(i);
}

}  // namespace clevis
