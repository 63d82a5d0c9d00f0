#include "cad/source_text.h"

#include <fmt/format.h>

namespace clevis::cad {
namespace {

using Eigen::Vector3d;

std::string text_of(const Vector3d& v) {
  return fmt::format("({},{},{})", v.x(), v.y(), v.z());
}

/// Calls that write a selector.
struct TextOf {
  std::string operator()(const part::CylinderSelector& cylinder) const {
    std::string text = "cylinder";
    if (cylinder.diameter) text += fmt::format(" {}", *cylinder.diameter);
    if (cylinder.near) text += " near " + text_of(*cylinder.near);
    if (cylinder.axis) text += " axis " + text_of(*cylinder.axis);
    return text;
  }
  std::string operator()(const part::PlaneSelector& plane) const {
    const std::string text = "plane " + text_of(plane.normal);
    return plane.through ? text + " through " + text_of(*plane.through) : text;
  }
  std::string operator()(const part::NearestSelector& nearest) const {
    return "nearest " + text_of(nearest.point);
  }
  std::string operator()(const part::LabelSelector& wanted) const {
    return fmt::format("label {} {}", wanted.label.size(), wanted.label);
  }
  std::string operator()(const std::vector<part::FaceSelector>& all) const {
    std::string text = "[";
    for (const auto& one : all) text += std::visit(*this, one.what) + ";";
    return text + "]";
  }
};

}  // namespace

std::string text_of(const part::SolidSource& source) {
  std::string text = fmt::format("unit {}\n", source.length_unit);
  if (source.mesh_size) text += fmt::format("size {}\n", *source.mesh_size);
  if (!source.sweep) text += "in space\n";
  for (const auto& named : source.faces) {
    text += fmt::format("{} {}\n", named.group,
                        std::visit(TextOf(), named.selector.what));
  }
  for (const auto& joint : source.joints) {
    text += fmt::format("{} {} {}\n", joint.group, text_of(joint.p_LJ),
                        text_of(joint.axis_L));
  }
  return text;
}

}  // namespace clevis::cad
