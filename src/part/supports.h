#pragma once

#include <array>
#include <map>
#include <string>

namespace clevis::part {

/// Components of the displacement (x, y, z) that are held at zero, per group;
/// empty: a free part.
using Supports = std::map<std::string, std::array<bool, 3>>;

/// Elastic bed of a face: traction against its displacement [N/m³].
struct Foundation {
  double normal{};      ///< across the face
  double tangential{};  ///< along it

  bool operator==(const Foundation&) const = default;
};
/// By group of the mesh.
using Foundations = std::map<std::string, Foundation>;

}  // namespace clevis::part
