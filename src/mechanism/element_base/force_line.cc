#include "mechanism/element_base/force_line.h"

#include "base/values/index.h"
#include "mechanism/joints/joint_types.h"

namespace clevis::mechanism {

bool is_angle(const ElementLine& line,
              const std::vector<JointDefinition>& joints) {
  if (line.kind != ElementLine::Kind::kJoint) return false;
  return coordinate_row(joints[index(line.joint)].type, line.coordinate)
      .is_angle();
}

}  // namespace clevis::mechanism
