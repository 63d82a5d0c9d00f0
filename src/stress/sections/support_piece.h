#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "elasticity/fe_space/discretization.h"
#include "part/supports.h"
#include "stress/sections/plane_section.h"

namespace clevis::stress {

/// A connected plane piece of what holds a part.
struct SupportPiece {
  std::vector<std::string> groups;  ///< whose faces it has
  PlaneSection section;
  std::vector<int> nodes;     ///< of the discretisation, sorted
  Eigen::Matrix3Xd extremes;  ///< its outermost points [m]
};

/// The plane pieces of the held faces: of a group each connected one, of
/// groups that meet in one plane one together, so that a section does not
/// depend on how its faces are named. Pieces that are not plane are left out.
/// @param fixed  components held at zero per group.
template <int dim>
std::vector<SupportPiece> support_pieces(
    const elasticity::Discretization<dim>& discretization,
    const part::Supports& fixed);

}  // namespace clevis::stress
