#pragma once

#include <optional>

#include "cad/face.h"

namespace clevis::cad {

/// A solid of one profile between two planes z = const.
struct Plate {
  int bottom{}, top{};  ///< numbers of these faces
  double thickness{};   ///< [m]
};

/// Whether a solid is a plate along z: one plane face below, one above, all
/// others planes and cylinders parallel to z, and at most half as thick as
/// wide.
std::optional<Plate> plate_of(const Solid& solid);

}  // namespace clevis::cad
