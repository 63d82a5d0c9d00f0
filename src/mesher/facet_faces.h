#pragma once

#include <vector>

#include <TopoDS_Solid.hxx>

#include "cad/face.h"

namespace clevis::mesher {

/// Triangles of each face of a solid in millimetres, in the order of
/// describe(): within a thousandth of its size and 0.2 rad. A face that
/// OpenCASCADE cannot fill has none.
std::vector<cad::Facets> facets_of(const TopoDS_Solid& solid);

}  // namespace clevis::mesher
