#include "cad/joint_cylinder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "base/messages/errors.h"
#include "cad/unit_slip.h"

namespace clevis::cad {
namespace {

using Eigen::Vector3d;

/// Ends of a cylinder along the joint's axis from the joint's point [m].
struct Extent {
  double low{}, high{};
};

Extent extent(const Cylinder& cylinder, const part::JointFaces& joint) {
  const double middle = joint.axis_L.dot(cylinder.point - joint.p_LJ);
  return {middle - cylinder.length / 2, middle + cylinder.length / 2};
}

/// Of cylinders of one diameter: the one about the joint's point, or the
/// nearest on either side of it; none if they lie on one side.
std::vector<Cylinder> about_point(const std::vector<Cylinder>& cylinders,
                                  const part::JointFaces& joint) {
  const Cylinder *below = nullptr, *above = nullptr;
  double nearest_below = -std::numeric_limits<double>::infinity();
  double nearest_above = -nearest_below;
  for (const Cylinder& cylinder : cylinders) {
    const auto [low, high] = extent(cylinder, joint);
    const double slack = 1e-3 * cylinder.length;
    if (low <= slack && high >= -slack) return {cylinder};
    if (high < 0.0 && high > nearest_below) {
      nearest_below = high;
      below = &cylinder;
    }
    if (low > 0.0 && low < nearest_above) {
      nearest_above = low;
      above = &cylinder;
    }
  }
  if (below == nullptr || above == nullptr) return {};
  return {*below, *above};
}

/// What may take a joint, bores (or shafts) that go all round or those that a
/// keyway or a slot opens.
struct Sort {
  bool hollow, is_round;

  bool has(const Cylinder& cylinder) const {
    return cylinder.hollow == hollow &&
           (is_round ? cylinder.is_round()
                     : !cylinder.is_round() && cylinder.closes_about_pin());
  }
};

/// Coaxial cylinders of a sort, by diameter, where they lie about the joint's
/// point.
std::vector<std::vector<Cylinder>> candidates(const std::vector<Cylinder>& all,
                                              const part::JointFaces& joint,
                                              const Sort& sort) {
  std::vector<std::vector<Cylinder>> by_diameter;
  for (const Cylinder& cylinder : all) {
    if (!sort.has(cylinder) ||
        !are_coaxial(cylinder, joint.p_LJ, joint.axis_L)) {
      continue;
    }
    const auto same = std::ranges::find_if(by_diameter, [&](const auto& group) {
      constexpr double kSame = 1e-3;
      return std::abs(group.front().radius - cylinder.radius) <=
             kSame * cylinder.radius;
    });
    if (same == by_diameter.end()) {
      by_diameter.push_back({cylinder});
    } else {
      same->push_back(cylinder);
    }
  }
  std::vector<std::vector<Cylinder>> found;
  for (const auto& group : by_diameter) {
    auto here = about_point(group, joint);
    if (!here.empty()) found.push_back(std::move(here));
  }
  return found;
}

[[noreturn]] void refuse(const part::JointFaces& joint,
                         const std::string& problem,
                         const std::string& first_remedy = "") {
  throw Error("M017", joint.place,
              fmt::format("joint {}: {}", joint.joint, problem),
              fmt::format("{}Name the faces: pins = {{ {} = \"bore_x\" }}, "
                          "faces.bore_x = {{ cylinder = {{ diameter = \"...\", "
                          "near = [...] }} }}; or correct the joint's place on "
                          "the body.",
                          first_remedy, joint.joint));
}

/// How far a cylinder is from being a joint's.
struct Miss {
  Cylinder cylinder;
  double tilt{};    ///< between both axes [rad]
  double beside{};  ///< of the joint's point from the cylinder's axis [m]
  double along{};   ///< of that point from the cylinder's nearer end [m]
  double rank{};    ///< of the nearest the least [m]
};

/// Of a part of some size [m]. Whole bores and shafts rank before arcs.
Miss miss_of(const Cylinder& cylinder, const part::JointFaces& joint,
             double size) {
  const Vector3d away = joint.p_LJ - cylinder.point;
  Miss miss{.cylinder = cylinder};
  const double sine = std::min(1.0, cylinder.axis.cross(joint.axis_L).norm());
  miss.tilt = std::asin(sine);
  miss.beside = away.cross(cylinder.axis).norm();
  miss.along =
      std::max(0.0, std::abs(away.dot(cylinder.axis)) - cylinder.length / 2);
  miss.rank = std::hypot(miss.beside, miss.along) + size * sine +
              (cylinder.is_round() ? 0.0 : size) +
              (cylinder.hollow ? 0.0 : size);
  return miss;
}

std::string text_of(const Miss& miss) {
  const auto degrees = [](double angle) {
    return 180.0 / std::numbers::pi * angle;
  };
  std::string off;
  const auto add = [&](const std::string& text) {
    off += (off.empty() ? "" : ", ") + text;
  };
  if (miss.tilt > kSameDirection) {
    add(fmt::format("its axis turned by {:.3g} deg", degrees(miss.tilt)));
  }
  if (miss.beside > 2e-3 * miss.cylinder.radius) {
    add(fmt::format("its axis {:.4g} mm from the point", 1e3 * miss.beside));
  }
  if (miss.along > 0.0) {
    add(fmt::format("its end {:.4g} mm off along it", 1e3 * miss.along));
  }
  if (!miss.cylinder.is_round()) {
    add(fmt::format("only {:.3g} deg of a turn", degrees(miss.cylinder.angle)));
  }
  return fmt::format("{} ({})", text_of(miss.cylinder), off);
}

/// Bores and shafts, those next to fitting first.
std::string nearest_of(const std::vector<Cylinder>& all,
                       const part::JointFaces& joint, double size) {
  constexpr std::size_t kMost = 5;
  if (all.empty()) return "no cylinder at all";
  std::vector<Miss> misses;
  for (const Cylinder& cylinder : all) {
    misses.push_back(miss_of(cylinder, joint, size));
  }
  std::ranges::stable_sort(misses, {}, &Miss::rank);
  std::string text;
  for (std::size_t i = 0; i < std::min(kMost, misses.size()); ++i) {
    text += (i == 0 ? "" : "; ") + text_of(misses[i]);
  }
  if (all.size() > kMost)
    text += fmt::format("; and {} more", all.size() - kMost);
  return text;
}

/// Whether a joint whose place is multiplied by a factor has its bore. The
/// origin stays where it is: bores about it tell nothing.
bool fits_scaled(const std::vector<Cylinder>& all,
                 const part::JointFaces& joint, double factor) {
  part::JointFaces scaled = joint;
  scaled.p_LJ *= factor;
  const double aside = scaled.p_LJ.cross(joint.axis_L).norm();
  return std::ranges::any_of(candidates(all, scaled, {true, true}),
                             [&](const auto& group) {
                               return group.front().radius < aside;
                             });
}

}  // namespace

std::vector<Cylinder> joint_cylinders(const Solid& solid,
                                      const part::JointFaces& joint) {
  const std::vector<Cylinder> all = cylinders_of(solid);
  // What goes all round comes first: a curved slot about a joint is none.
  constexpr std::array<Sort, 4> kSorts = {
      {{true, true}, {false, true}, {true, false}, {false, false}}};
  for (const Sort& sort : kSorts) {
    const auto found = candidates(all, joint, sort);
    if (found.size() == 1) return found.front();
    if (found.empty()) continue;
    std::vector<Cylinder> listed;
    for (const auto& group : found) {
      listed.insert(listed.end(), group.begin(), group.end());
    }
    refuse(joint,
           fmt::format("{} diameters lie on its axis about its point: {}",
                       found.size(), list_of(listed)));
  }
  const Vector3d p = 1e3 * joint.p_LJ, a = joint.axis_L;
  const std::string problem = fmt::format(
      "no bore and no shaft of the part lies on its axis about its point "
      "({:.6g}, {:.6g}, {:.6g}) mm, axis ({:.4g}, {:.4g}, {:.4g}), in the "
      "part's frame",
      p.x() + 0.0, p.y() + 0.0, p.z() + 0.0, a.x() + 0.0, a.y() + 0.0,
      a.z() + 0.0);
  const auto slip = unit_slip([&](double factor) {
    return fits_scaled(all, joint, factor);
  });
  const std::string nearest =
      nearest_of(all, joint, (solid.high - solid.low).norm());
  if (!slip) refuse(joint, problem + "; nearest: " + nearest);
  refuse(joint,
         fmt::format("{}, but one does at {:.4g} times its distance from the "
                     "part's origin; nearest: {}",
                     problem, slip->factor, nearest),
         fmt::format("A unit seems wrong ({}): compare that of the joint's "
                     "point with that of the file, which `clevis faces FILE` "
                     "prints. Else: ",
                     slip->units));
}

}  // namespace clevis::cad
