#pragma once

#include <string>
#include <utility>
#include <vector>

#include <TopoDS_Shape.hxx>

#include "cad/exchange.h"

namespace clevis::mesher {

/// What a CAD file holds, in millimetres.
struct ReadShape {
  TopoDS_Shape shape;
  std::string unit;  ///< of lengths in the file; empty: it gives none
  /// Faces, or shapes of faces, that a STEP file names.
  std::vector<std::pair<TopoDS_Shape, std::string>> labels = {};
};

/// Reads STEP, IGES or BREP by OpenCASCADE, by the format that is asked for,
/// whatever the file's name. Closed surfaces of an IGES file, which knows
/// hardly any solids, are sewn into one.
/// @throws Error M010 if the file is damaged or holds nothing.
ReadShape read_shape(const cad::Request& request);

}  // namespace clevis::mesher
