#pragma once

#include <string>

#include "mechanism/definition/definition.h"
#include "part/solid_source.h"
#include "scene/text/value.h"

namespace clevis::scene {

/// The word in place of a group's name: the joint finds its faces.
inline constexpr const char* kAutoFaces = "auto";

/// Asks a solid for the cylinder on the axis of a joint of its body, once.
/// @return the group that its faces will be.
/// @throws Error S010 if the joint has no axis, S008 if `faces` of the part
///   has a group of that name.
std::string find_by_joint(const mechanism::JointDefinition& joint,
                          mechanism::BodyIndex body, const std::string& place,
                          part::SolidSource& solid);

}  // namespace clevis::scene
