#include "scene/solids/joint_faces.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/messages/errors.h"
#include "mechanism/joints/joint_types.h"

namespace clevis::scene {

std::string find_by_joint(const mechanism::JointDefinition& joint,
                          mechanism::BodyIndex body, const std::string& place,
                          part::SolidSource& solid) {
  using Axis = mechanism::JointTraits::Axis;
  const auto& traits = mechanism::traits(joint.type);
  const std::string group = "bore_" + joint.name;
  if (traits.axis != Axis::kNeeded) {
    throw Error("S010", place,
                fmt::format("joint \"{}\" is {}, which has no axis to find a "
                            "bore by",
                            joint.name, traits.name),
                "Name the group in pins = { JOINT = \"GROUP\" } and its faces "
                "in [part.faces].");
  }
  if (std::ranges::count(solid.faces, group, &part::NamedFaces::group) > 0) {
    throw Error("S008", place,
                fmt::format("the faces of joint \"{}\" would be a second "
                            "group {}",
                            joint.name, group),
                fmt::format("Write pins = {{ {} = \"{}\" }}, or give the "
                            "group of [part.faces] another name.",
                            joint.name, group));
  }
  const auto& frame = joint.body_a == body ? joint.frame_a : joint.frame_b;
  solid.joints.push_back(
      {joint.name, group, frame.p_LJ, frame.R_LJ.col(2), place});
  return group;
}

}  // namespace clevis::scene
