#pragma once

#include <optional>
#include <string>

#include <Eigen/Core>

#include "cad/face.h"

namespace clevis::cad {

/// A solid of one profile between two parallel planes.
struct Plate {
  int bottom{}, top{};  ///< numbers of these faces
  double thickness{};   ///< [m]
  /// From bottom to top; along z where it can be.
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();

  bool is_along_z() const { return normal.z() == 1.0; }
};

/// Whether a solid is a plate: one plane face at either end of a direction, all
/// others planes and cylinders parallel to it, and at most half as thick as
/// wide.
std::optional<Plate> plate_of(const Solid& solid);

/// "a plate along x, 8 mm thick".
std::string text(const Plate& plate);

}  // namespace clevis::cad
