#pragma once

#include <string>

namespace clevis::part {

/// Linear elastic isotropic material.
struct Material {
  std::string name;
  double youngs_modulus{};  ///< [Pa], > 0
  double poissons_ratio{};  ///< [1], -1 < ν < 0.5
  double density{};         ///< [kg/m³], > 0
  double yield_strength{};  ///< [Pa], > 0
};

}  // namespace clevis::part
