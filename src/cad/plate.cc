#include "cad/plate.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace clevis::cad {
namespace {

using Eigen::Vector3d;

constexpr double kSame = 1e-6;  // of directions [rad], of heights over the size

bool is_along(const Vector3d& direction, const Vector3d& normal) {
  return direction.cross(normal).norm() <= kSame;
}

bool is_across(const Vector3d& direction, const Vector3d& normal) {
  return std::abs(direction.dot(normal)) <= kSame;
}

/// A direction as its nearest coordinate axis where it is one, and rather up
/// than down.
Vector3d tidy(Vector3d normal) {
  for (int d = 0; d < 3; ++d) {
    if (is_along(normal, Vector3d::Unit(d))) return Vector3d::Unit(d);
  }
  Eigen::Index largest = 0;
  normal.cwiseAbs().maxCoeff(&largest);
  return normal[largest] < 0.0 ? Vector3d(-normal) : normal;
}

/// Least extent across the normal: of the box where that is an axis, else what
/// the bottom's area leaves over its longest extent.
double width_of(const Solid& solid, const Vector3d& normal, double area) {
  const Vector3d size = solid.high - solid.low;
  for (int d = 0; d < 3; ++d) {
    if (normal == Vector3d::Unit(d)) {
      return std::min(size[(d + 1) % 3], size[(d + 2) % 3]);
    }
  }
  return area / size.norm();
}

std::optional<Plate> plate_along(const Solid& solid, const Vector3d& normal) {
  constexpr double kThickest = 0.5;  // of the width
  Plate plate;
  plate.normal = normal;
  const Face* bottom = nullptr;
  const Face* top = nullptr;
  for (const Face& face : solid.faces) {
    if (face.kind == SurfaceKind::kCylinder && is_along(face.axis, normal)) {
      continue;
    }
    if (face.kind != SurfaceKind::kPlane) return std::nullopt;
    if (is_across(face.normal, normal)) continue;
    const Face*& end = face.normal.dot(normal) < 0.0 ? bottom : top;
    if (!is_along(face.normal, normal) || end != nullptr) return std::nullopt;
    end = &face;
  }
  if (bottom == nullptr || top == nullptr) return std::nullopt;
  plate.bottom = bottom->number;
  plate.top = top->number;
  plate.thickness = (top->centre - bottom->centre).dot(normal);
  const double width = width_of(solid, normal, bottom->area);
  if (!(plate.thickness > 0.0) || plate.thickness > kThickest * width) {
    return std::nullopt;
  }
  return plate;
}

}  // namespace

std::optional<Plate> plate_of(const Solid& solid) {
  // z first: of a cube's like the plate that its models know.
  std::vector<Vector3d> directions{Vector3d::UnitZ()};
  for (const Face& face : solid.faces) {
    if (face.kind != SurfaceKind::kPlane) continue;
    const Vector3d normal = tidy(face.normal);
    if (std::ranges::none_of(directions, [&](const Vector3d& other) {
          return is_along(normal, other);
        })) {
      directions.push_back(normal);
    }
  }
  for (const Vector3d& normal : directions) {
    if (auto plate = plate_along(solid, normal)) return plate;
  }
  return std::nullopt;
}

std::string text(const Plate& plate) {
  constexpr std::array kAxes{"x", "y", "z"};
  std::string along = fmt::format("({:.4g}, {:.4g}, {:.4g})", plate.normal.x(),
                                  plate.normal.y(), plate.normal.z());
  for (int d = 0; d < 3; ++d) {
    if (plate.normal == Vector3d::Unit(d)) {
      along = kAxes[static_cast<std::size_t>(d)];
    }
  }
  return fmt::format("a plate along {}, {:.6g} mm thick", along,
                     1e3 * plate.thickness);
}

}  // namespace clevis::cad
