#pragma once

#include "mechanism/definition.h"

namespace clevis::mechanism {

/// Whether the two bodies of a joint slide on one another.
inline bool slides(JointType type) {
  return type == JointType::kPrismatic || type == JointType::kCylindrical ||
         type == JointType::kScrew || type == JointType::kPlanar;
}

}  // namespace clevis::mechanism
