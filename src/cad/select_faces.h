#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "cad/face.h"
#include "part/solid_source.h"

namespace clevis::cad {

/// Points whose distances from the faces selectors need, each once.
std::vector<Eigen::Vector3d> points_of(const part::SolidSource& source);

/// Faces that a selector means, by number.
/// @param solid  with the distances of `points`.
/// @throws Error M017 if none fits, or faces of several cylinders or planes.
std::vector<int> select_faces(const Solid& solid,
                              const std::vector<Eigen::Vector3d>& points,
                              const part::FaceSelector& selector);

}  // namespace clevis::cad
