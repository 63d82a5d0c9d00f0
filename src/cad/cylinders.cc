#include "cad/cylinders.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace clevis::cad {
namespace {

using Eigen::Vector3d;

constexpr double kSame = 1e-3;  // of the radius: lengths that are meant equal

/// Of the normals away from the axis, which point from it to the surface.
Vector3d area_vector(const Face& face) {
  const Vector3d from_axis = face.centre - face.axis_point;
  return face.area / face.radius *
         (from_axis - from_axis.dot(face.axis) * face.axis);
}

Cylinder cylinder_of(const Face& face) {
  const double middle = (face.low + face.high) / 2;
  return {.faces = {face.number},
          .point = face.axis_point + middle * face.axis,
          .axis = face.axis,
          .radius = face.radius,
          .length = face.high - face.low,
          .angle = face.angle,
          .wall = {face.area, area_vector(face), face.normal_square},
          .hollow = face.hollow};
}

/// Place of a point along a cylinder's axis, from its middle [m].
double along(const Cylinder& cylinder, const Vector3d& point) {
  return cylinder.axis.dot(point - cylinder.point);
}

bool continues(const Cylinder& a, const Cylinder& b) {
  const double gap = std::abs(along(a, b.point)) - (a.length + b.length) / 2;
  return a.hollow == b.hollow &&
         std::abs(a.radius - b.radius) <= kSame * a.radius &&
         are_coaxial(a, b.point, b.axis) && gap <= kSame * a.radius;
}

/// Both as one; faces at the same place along the axis add their angles.
void merge(Cylinder& cylinder, const Cylinder& other) {
  const double at = along(cylinder, other.point);
  const double low = std::min(-cylinder.length / 2, at - other.length / 2);
  const double high = std::max(cylinder.length / 2, at + other.length / 2);
  // Areas over 2 r: what both cover, whether side by side or end to end.
  const double covered =
      cylinder.angle * cylinder.length + other.angle * other.length;
  cylinder.point += (low + high) / 2 * cylinder.axis;
  cylinder.length = high - low;
  cylinder.angle = covered / cylinder.length;
  cylinder.wall += other.wall;
  cylinder.faces.insert(cylinder.faces.end(), other.faces.begin(),
                        other.faces.end());
  std::ranges::sort(cylinder.faces);
}

}  // namespace

bool Cylinder::is_round() const {
  constexpr double kNearly = 0.9;  // cross bores and keyways take their share
  return angle > kNearly * 2 * std::numbers::pi;
}

bool Cylinder::closes_about_pin() const {
  constexpr double kLeast = 0.75;
  return angle > kLeast * 2 * std::numbers::pi;
}

std::vector<Cylinder> cylinders_of(const Solid& solid) {
  std::vector<Cylinder> found;
  for (const Face& face : solid.faces) {
    if (face.kind != SurfaceKind::kCylinder) continue;
    Cylinder cylinder = cylinder_of(face);
    // One face may join two that had a gap between them.
    for (auto other = found.begin(); other != found.end();) {
      if (continues(cylinder, *other)) {
        merge(cylinder, *other);
        found.erase(other);
        other = found.begin();
      } else {
        ++other;
      }
    }
    found.push_back(std::move(cylinder));
  }
  std::ranges::sort(found, {}, [](const Cylinder& c) {
    return c.faces.front();
  });
  return found;
}

bool are_parallel(const Vector3d& a, const Vector3d& b) {
  return a.cross(b).norm() <= kSameDirection;
}

bool are_coaxial(const Cylinder& cylinder, const Vector3d& point,
                 const Vector3d& axis) {
  const Vector3d from_axis = (point - cylinder.point).cross(cylinder.axis);
  return are_parallel(cylinder.axis, axis) &&
         from_axis.norm() <= 2.0 * kSame * cylinder.radius;
}

std::vector<std::vector<Cylinder>> by_axis(
    const std::vector<Cylinder>& cylinders) {
  std::vector<std::vector<Cylinder>> found;
  for (const Cylinder& cylinder : cylinders) {
    const auto same = std::ranges::find_if(found, [&](const auto& pieces) {
      const Cylinder& first = pieces.front();
      return first.hollow == cylinder.hollow &&
             std::abs(first.radius - cylinder.radius) <= kSame * first.radius &&
             are_coaxial(first, cylinder.point, cylinder.axis);
    });
    if (same == found.end()) {
      found.push_back({cylinder});
    } else {
      same->push_back(cylinder);
    }
  }
  return found;
}

std::string text_of(const Cylinder& cylinder) {
  const Vector3d p = 1e3 * cylinder.point;
  // Adding zero turns -0 into 0.
  const auto number = [](double value) {
    return fmt::format("{:.6g}", std::round(1e6 * value) / 1e6 + 0.0);
  };
  return fmt::format(
      "{} of diameter {} mm, {} mm long, middle ({}, {}, {}) mm, face{} {}",
      cylinder.hollow ? (cylinder.is_round() ? "bore" : "hollow arc")
                      : (cylinder.is_round() ? "shaft" : "outer arc"),
      number(2e3 * cylinder.radius), number(1e3 * cylinder.length),
      number(p.x()), number(p.y()), number(p.z()),
      cylinder.faces.size() > 1 ? "s" : "", fmt::join(cylinder.faces, ", "));
}

std::string list_of(const std::vector<Cylinder>& cylinders) {
  constexpr std::size_t kMost = 12;
  if (cylinders.empty()) return "none";
  std::string text;
  for (std::size_t i = 0; i < std::min(kMost, cylinders.size()); ++i) {
    text += (i == 0 ? "" : "; ") + text_of(cylinders[i]);
  }
  if (cylinders.size() > kMost) {
    text += fmt::format("; and {} more", cylinders.size() - kMost);
  }
  return text;
}

}  // namespace clevis::cad
