#pragma once

#include <vector>

#include <TopoDS_Face.hxx>
#include <gp_Pnt.hxx>

namespace clevis::mesher {

/// Size of cells that a surface may have where it bends as it does there.
struct BendSize {
  gp_Pnt at;      ///< [mm]
  double size{};  ///< [mm]
};

/// Sizes over a face, so close to each other where they are small that a cell
/// of that size sees them.
struct BendSizes {
  std::vector<BendSize> places;  ///< where the size is below the largest
  double coarsest{};             ///< of all places, at most the largest [mm]
};

/// By the curvature in each span of a face's splines: a notch may be as narrow
/// as one of them.
/// @param turn     of the normal along a cell [rad].
/// @param largest  size of cells elsewhere [mm].
BendSizes bend_sizes(const TopoDS_Face& face, double turn, double largest);

}  // namespace clevis::mesher
