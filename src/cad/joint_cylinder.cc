#include "cad/joint_cylinder.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "base/messages/errors.h"

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

/// Coaxial cylinders that are bores (or shafts), by diameter, where they lie
/// about the joint's point.
std::vector<std::vector<Cylinder>> candidates(const std::vector<Cylinder>& all,
                                              const part::JointFaces& joint,
                                              bool hollow) {
  std::vector<std::vector<Cylinder>> by_diameter;
  for (const Cylinder& cylinder : all) {
    if (cylinder.hollow != hollow || !cylinder.is_round() ||
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
                         const std::vector<Cylinder>& listed) {
  throw Error(
      "M017", joint.place,
      fmt::format("joint {}: {}: {}", joint.joint, problem, list_of(listed)),
      fmt::format("Name the faces: pins = {{ {} = \"bore_x\" }}, "
                  "faces.bore_x = {{ cylinder = {{ diameter = \"...\", "
                  "near = [...] }} }}; or correct the joint's place on "
                  "the body.",
                  joint.joint));
}

}  // namespace

std::vector<Cylinder> joint_cylinders(const Solid& solid,
                                      const part::JointFaces& joint) {
  const std::vector<Cylinder> all = cylinders_of(solid);
  for (const bool hollow : {true, false}) {
    const auto found = candidates(all, joint, hollow);
    if (found.size() == 1) return found.front();
    if (found.empty()) continue;
    std::vector<Cylinder> listed;
    for (const auto& group : found) {
      listed.insert(listed.end(), group.begin(), group.end());
    }
    refuse(joint,
           fmt::format("{} diameters lie on its axis about its point",
                       found.size()),
           listed);
  }
  const Vector3d p = 1e3 * joint.p_LJ, a = joint.axis_L;
  refuse(joint,
         fmt::format("no bore and no shaft of the part lies on its axis about "
                     "its point ({:.6g}, {:.6g}, {:.6g}) mm, axis ({:.4g}, "
                     "{:.4g}, {:.4g}), in the part's frame; the part has",
                     p.x() + 0.0, p.y() + 0.0, p.z() + 0.0, a.x() + 0.0,
                     a.y() + 0.0, a.z() + 0.0),
         all);
}

}  // namespace clevis::cad
