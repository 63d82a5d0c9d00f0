#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "cad/face.h"
#include "cad/pin_bores.h"

namespace clevis::cad {

/// How a solid of which nothing but its shape is known may be held and loaded,
/// for a user to begin with: one bore against another, a bore against a plane
/// face, or two plane faces against each other.
struct FirstCase {
  std::vector<PinBore> bores;  ///< all, in the order of pin_bores()
  std::optional<std::size_t> held, pulled;  ///< of `bores`
  std::optional<int> base;  ///< plane face that holds instead of a bore: number
  std::optional<int> end;   ///< plane face that is pulled instead of a bore
  /// Of the load on the part, a unit vector: across the pulled bore, without a
  /// moment about the axis of the held one.
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
};

/// Two bores: the widest holds, the next is pulled away from it. Of one bore,
/// or a widest one beside holes for bolts, a plane face holds. Without bores
/// the ends of the solid are pulled apart.
/// @param place  the file, for messages.
/// @throws Error M017 if the solid has no such faces.
FirstCase first_case(const Solid& solid, const std::string& place);

}  // namespace clevis::cad
