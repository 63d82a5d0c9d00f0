#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "cad/face.h"

namespace clevis::cad {

/// A cylindrical face about z.
inline Face cylinder_face(int number, double x, double low, double high,
                          double diameter, bool hollow,
                          double angle = 2 * std::numbers::pi) {
  Face face;
  face.number = number;
  face.kind = SurfaceKind::kCylinder;
  face.axis_point = {x, 0.0, 0.0};
  face.axis = {0.0, 0.0, 1.0};
  face.low = low;
  face.high = high;
  face.radius = diameter / 2;
  face.hollow = hollow;
  face.angle = angle;
  face.area = angle * face.radius * (high - low);
  const double chord = std::sin(angle / 2) / (angle / 2);  // over the arc
  face.centre = {x + face.radius * chord, 0.0, (low + high) / 2};
  const double turn = std::sin(angle) / angle;
  face.normal_square.diagonal() =
      face.area / 2 * Eigen::Vector3d(1.0 + turn, 1.0 - turn, 0.0);
  return face;
}

/// A plane face.
inline Face plane_face(int number, const Eigen::Vector3d& centre,
                       const Eigen::Vector3d& normal) {
  Face face;
  face.number = number;
  face.kind = SurfaceKind::kPlane;
  face.centre = centre;
  face.normal = normal;
  return face;
}

/// A solid of these faces in a box of 100 mm.
inline Solid solid_of(std::vector<Face> faces) {
  Solid solid;
  solid.low = {0.0, -0.05, -0.05};
  solid.high = {0.1, 0.05, 0.05};
  solid.faces = std::move(faces);
  return solid;
}

}  // namespace clevis::cad
