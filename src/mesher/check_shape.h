#pragma once

#include <string>

#include <TopoDS_Solid.hxx>

namespace clevis::mesher {

/// The one solid of a shape, its faces looking outwards.
/// @param file  for messages.
/// @throws Error M016 with what is wrong and where: no solid, several, loose
///   faces, open shells, edges of more or fewer than two faces, what
///   BRepCheck_Analyzer finds, faces that cut each other.
TopoDS_Solid one_sound_solid(const TopoDS_Shape& shape,
                             const std::string& file);

}  // namespace clevis::mesher
