#pragma once

#include <array>
#include <map>
#include <string>

namespace clevis::part {

/// Components of the displacement (x, y, z) that are held at zero, per group;
/// empty: a free part.
using Supports = std::map<std::string, std::array<bool, 3>>;

}  // namespace clevis::part
