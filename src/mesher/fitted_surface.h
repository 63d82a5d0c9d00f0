#pragma once

#include <BRepAdaptor_Surface.hxx>
#include <TopoDS_Face.hxx>

#include "cad/face.h"

namespace clevis::mesher {

/// Bounds of a face's parameters.
struct Patch {
  double u0{}, u1{}, v0{}, v1{};
};

/// Whether a face is plane, cylindrical, conical, spherical or toroidal.
bool is_elementary(const TopoDS_Face& face);

/// Plane or cylinder under a face that its file gives as a spline, or as a line
/// or circle that is swept or turned: kind, axis, radius, turn and extent, from
/// points and normals on a grid of its parameters. Such a cylinder is round to
/// 1e-5 of its radius.
/// @return whether it is one; else the face stays as it is.
bool fit_surface(const BRepAdaptor_Surface& surface, const Patch& patch,
                 cad::Face& face);

}  // namespace clevis::mesher
