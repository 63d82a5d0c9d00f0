#pragma once

namespace clevis::mesher {

/// Takes tetrahedra of degree 1 out of gmsh's mesh that have two faces on one
/// surface of the model: where that is smooth they have no volume beside the
/// common edge, and fold or kink the surface once they are curved. The edge
/// across becomes the surface's. Stay: cells with three faces there, and those
/// whose two faces make no convex quadrangle.
/// @pre the model has one volume.
void flip_surface_edges();

}  // namespace clevis::mesher
