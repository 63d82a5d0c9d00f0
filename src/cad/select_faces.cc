#include "cad/select_faces.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/messages/errors.h"
#include "cad/cylinders.h"
#include "cad/unit_slip.h"

namespace clevis::cad {
namespace {

using Eigen::Vector3d;
using part::FaceSelector;

constexpr double kSame = 1e-3;  // of lengths, relative

/// Calls that collect the points of a selector.
struct PointsOf {
  std::vector<Vector3d>& points;

  void add(const Vector3d& point) const {
    if (std::ranges::find(points, point) == points.end()) {
      points.push_back(point);
    }
  }
  void operator()(const part::CylinderSelector& cylinder) const {
    if (cylinder.near) add(*cylinder.near);
  }
  void operator()(const part::PlaneSelector&) const {}
  void operator()(const part::NearestSelector& nearest) const {
    add(nearest.point);
  }
  void operator()(const part::LabelSelector&) const {}
  void operator()(const std::vector<FaceSelector>& all) const {
    for (const FaceSelector& one : all) std::visit(*this, one.what);
  }
};

/// Calls that find the faces of a selector.
struct FacesOf {
  const Solid& solid;
  const std::vector<Vector3d>& points;
  const std::string& place;

  [[noreturn]] void refuse(const std::string& problem) const {
    throw Error("M017", place, problem,
                "`clevis faces FILE` lists all faces; say more of the one that "
                "is meant.");
  }

  double distance(const Vector3d& point, int face) const {
    const auto at = std::ranges::find(points, point) - points.begin();
    return solid.distances.at(std::size_t(at)).at(std::size_t(face) - 1);
  }

  double distance(const Vector3d& point, const Cylinder& cylinder) const {
    double nearest = distance(point, cylinder.faces.front());
    for (const int face : cylinder.faces) {
      nearest = std::min(nearest, distance(point, face));
    }
    return nearest;
  }

  std::vector<int> operator()(const part::CylinderSelector& wanted) const;
  std::vector<int> operator()(const part::PlaneSelector& wanted) const;
  std::vector<int> operator()(const part::NearestSelector& wanted) const;
  std::vector<int> operator()(const part::LabelSelector& wanted) const;
  std::vector<int> operator()(const std::vector<FaceSelector>& all) const;
};

bool has_diameter(const Cylinder& cylinder, double diameter) {
  return std::abs(2 * cylinder.radius - diameter) <= kSame * diameter;
}

/// Why no cylinder fits: those of the nearest diameters, and whether another
/// unit would help.
std::string none_fits(std::vector<Cylinder> all,
                      const part::CylinderSelector& wanted) {
  std::string problem = "no cylinder of the part fits";
  if (wanted.diameter) {
    const double diameter = *wanted.diameter;
    std::ranges::stable_sort(all, {}, [&](const Cylinder& c) {
      return std::abs(std::log(2 * c.radius / diameter));
    });
    const auto slip = unit_slip([&](double factor) {
      return std::ranges::any_of(all, [&](const Cylinder& c) {
        return has_diameter(c, factor * diameter);
      });
    });
    if (slip) {
      problem += fmt::format(
          ", but some have {:.4g} times the diameter {:.6g} mm: is a unit "
          "wrong ({})?",
          slip->factor, 1e3 * diameter, slip->units);
    }
  }
  constexpr std::size_t kMost = 5;
  const std::size_t n_more = all.size() - std::min(all.size(), kMost);
  all.resize(all.size() - n_more);
  return problem + "; it has " + list_of(all) +
         (n_more > 0 ? fmt::format("; and {} more", n_more) : "");
}

std::vector<int> FacesOf::operator()(
    const part::CylinderSelector& wanted) const {
  const std::vector<Cylinder> all = cylinders_of(solid);
  std::vector<Cylinder> found;
  for (const Cylinder& cylinder : all) {
    if (wanted.diameter && !has_diameter(cylinder, *wanted.diameter)) {
      continue;
    }
    if (wanted.axis && !are_parallel(cylinder.axis, *wanted.axis)) {
      continue;
    }
    found.push_back(cylinder);
  }
  if (found.empty()) refuse(none_fits(all, wanted));
  if (wanted.near && found.size() > 1) {
    const auto away = [&](const Cylinder& c) {
      return distance(*wanted.near, c);
    };
    std::ranges::sort(found, {}, away);
    const double size = (solid.high - solid.low).norm();
    if (away(found[1]) > away(found[0]) + kSame * size) found.resize(1);
  }
  if (by_axis(found).size() == 1) {
    std::vector<int> faces;
    for (const Cylinder& piece : found) {
      faces.insert(faces.end(), piece.faces.begin(), piece.faces.end());
    }
    return faces;
  }
  refuse(fmt::format("{} cylinders of the part fit: {}", found.size(),
                     list_of(found)));
}

std::vector<int> FacesOf::operator()(const part::PlaneSelector& wanted) const {
  const double size = (solid.high - solid.low).norm();
  // A selector is typed to a few digits, planes of one solid are not.
  constexpr double kOnePlane = 1e-5;  // of the size, and [rad]
  const auto from_point = [&](const Face* face) {
    return std::abs(face->normal.dot(*wanted.through - face->centre));
  };
  std::vector<const Face*> found;
  for (const Face& face : solid.faces) {
    if (face.kind != SurfaceKind::kPlane ||
        face.normal.dot(wanted.normal) < 1.0 - kSameDirection ||
        (wanted.through && from_point(&face) > kSame * size)) {
      continue;
    }
    found.push_back(&face);
  }
  if (found.empty()) refuse("no plane face of the part fits");
  if (wanted.through) std::ranges::stable_sort(found, {}, from_point);
  std::vector<int> faces;
  for (const Face* face : found) {
    const double offset =
        std::abs(face->normal.dot(face->centre - found.front()->centre));
    if (offset <= kOnePlane * size &&
        face->normal.cross(found.front()->normal).norm() <= kOnePlane) {
      faces.push_back(face->number);
      continue;
    }
    if (wanted.through &&
        from_point(face) > 2.0 * from_point(found.front()) + kOnePlane * size) {
      continue;
    }
    const Vector3d a = 1e3 * found.front()->centre, b = 1e3 * face->centre;
    refuse(
        fmt::format("faces {} and {} look that way from different planes, "
                    "through ({:.4g}, {:.4g}, {:.4g}) mm and ({:.4g}, "
                    "{:.4g}, {:.4g}) mm",
                    found.front()->number, face->number, a.x(), a.y(), a.z(),
                    b.x(), b.y(), b.z()));
  }
  return faces;
}

std::vector<int> FacesOf::operator()(
    const part::NearestSelector& wanted) const {
  std::vector<int> order;
  for (const Face& face : solid.faces) order.push_back(face.number);
  const auto away = [&](int face) {
    return distance(wanted.point, face);
  };
  std::ranges::stable_sort(order, {}, away);
  const double size = (solid.high - solid.low).norm();
  if (order.size() > 1 && away(order[1]) <= away(order[0]) + 1e-6 * size) {
    refuse(fmt::format("faces {} and {} are equally near, {:.4g} mm", order[0],
                       order[1], 1e3 * away(order[0])));
  }
  return {order.front()};
}

std::vector<int> FacesOf::operator()(const part::LabelSelector& wanted) const {
  std::vector<int> found;
  std::string labels;
  for (const Face& face : solid.faces) {
    if (face.label.empty()) continue;
    if (face.label == wanted.label) found.push_back(face.number);
    labels += fmt::format("{}\"{}\" of face {}", labels.empty() ? "" : ", ",
                          face.label, face.number);
  }
  if (found.size() == 1) return found;
  if (found.size() > 1) {
    refuse(fmt::format("the faces {} bear the label \"{}\"",
                       fmt::join(found, " "), wanted.label));
  }
  refuse(labels.empty()
             ? "no face of the part bears a label; those of STEP files may"
             : fmt::format("no face bears the label \"{}\"; there are {}",
                           wanted.label, labels));
}

std::vector<int> FacesOf::operator()(
    const std::vector<FaceSelector>& all) const {
  std::vector<int> faces;
  for (const FaceSelector& one : all) {
    const auto more = select_faces(solid, points, one);
    faces.insert(faces.end(), more.begin(), more.end());
  }
  std::ranges::sort(faces);
  const auto twice = std::ranges::unique(faces);
  faces.erase(twice.begin(), twice.end());
  if (faces.empty()) refuse("the list of selectors is empty");
  return faces;
}

}  // namespace

std::vector<Vector3d> points_of(const part::SolidSource& source) {
  std::vector<Vector3d> points;
  for (const part::NamedFaces& named : source.faces) {
    std::visit(PointsOf{points}, named.selector.what);
  }
  return points;
}

std::vector<int> select_faces(const Solid& solid,
                              const std::vector<Vector3d>& points,
                              const FaceSelector& selector) {
  return std::visit(FacesOf{solid, points, selector.place}, selector.what);
}

}  // namespace clevis::cad
