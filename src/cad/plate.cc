#include "cad/plate.h"

#include <algorithm>
#include <cmath>

namespace clevis::cad {
namespace {

constexpr double kSame = 1e-6;  // of directions [rad], of heights over the size

enum class Side { kBottom, kTop, kUpright, kOther };

Side side_of(const Face& face, const Solid& solid) {
  const double size = (solid.high - solid.low).norm();
  const double z = face.centre.z();
  if (face.kind == SurfaceKind::kCylinder) {
    return face.axis.head<2>().norm() <= kSame ? Side::kUpright : Side::kOther;
  }
  if (face.kind != SurfaceKind::kPlane) return Side::kOther;
  if (std::abs(face.normal.z()) <= kSame) return Side::kUpright;
  if (face.normal.head<2>().norm() > kSame) return Side::kOther;
  if (face.normal.z() < 0.0) {
    return std::abs(z - solid.low.z()) <= kSame * size ? Side::kBottom
                                                       : Side::kOther;
  }
  return std::abs(z - solid.high.z()) <= kSame * size ? Side::kTop
                                                      : Side::kOther;
}

}  // namespace

std::optional<Plate> plate_of(const Solid& solid) {
  constexpr double kThickest = 0.5;  // of the width
  Plate plate;
  plate.thickness = solid.high.z() - solid.low.z();
  const double width = (solid.high - solid.low).head<2>().minCoeff();
  if (plate.thickness > kThickest * width) return std::nullopt;
  for (const Face& face : solid.faces) {
    const Side side = side_of(face, solid);
    if (side == Side::kUpright) continue;
    int& number = side == Side::kBottom ? plate.bottom : plate.top;
    if (side == Side::kOther || number != 0) return std::nullopt;
    number = face.number;
  }
  if (plate.bottom == 0 || plate.top == 0) return std::nullopt;
  return plate;
}

}  // namespace clevis::cad
