#pragma once

#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <TopoDS_Solid.hxx>

#include "cad/face.h"

namespace clevis::mesher {

/// Size, volume and faces of a solid in millimetres, numbered as TopExp maps
/// them.
/// @param points  whose distances from the faces are wanted [m].
/// @throws Error M007 if it is smaller than 10 µm or larger than 100 m.
cad::Solid describe(const TopoDS_Solid& solid,
                    const std::vector<Eigen::Vector3d>& points,
                    const std::string& file);

/// Gives faces the names that their file has for them.
/// @param described  of this solid.
void add_labels(const TopoDS_Solid& solid,
                const std::vector<std::pair<TopoDS_Shape, std::string>>& labels,
                cad::Solid& described);

}  // namespace clevis::mesher
