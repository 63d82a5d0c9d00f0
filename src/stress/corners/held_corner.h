#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "mesh/cells/part_mesh.h"
#include "part/supports.h"
#include "stress/corners/boundary_corner.h"
#include "stress/corners/wedge_exponent.h"

namespace clevis::stress {

/// Support of a side: in the plane across the corner and along its axis.
struct HeldSide {
  WedgeSide wedge;
  bool along_axis{};
};

/// A corner with what is held beside it.
struct HeldCorner {
  BoundaryCorner corner;
  std::array<HeldSide, 2> held;
  std::array<std::string, 2> name;  ///< of the group of a side that holds
  /// Over straight, positive where the corner is re-entrant, of the material
  /// with its mirror image where one side is a roller; nothing where the sides
  /// are held unlike [rad].
  std::optional<double> kink;
};

/// All corners of a mesh.
template <int dim>
std::vector<HeldCorner> held_corners(const mesh::PartMesh<dim>& mesh,
                                     const part::Supports& fixed);

}  // namespace clevis::stress
