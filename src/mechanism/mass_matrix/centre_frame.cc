#include "mechanism/mass_matrix/centre_frame.h"

#include <vector>

#include "base/values/index.h"

namespace clevis::mechanism {

using Eigen::Vector3d;

SolvingFrame frame_at_centres(const MechanismDefinition& definition) {
  SolvingFrame frame(definition);
  std::vector<Vector3d> shift(definition.bodies.size() + 1, Vector3d::Zero());
  for (std::size_t i = 0; i < definition.bodies.size(); ++i) {
    shift[i + 1] = definition.bodies[i].mass_properties.p_LCm - frame.p_LM[i];
    frame.p_LM[i] = definition.bodies[i].mass_properties.p_LCm;
    frame.placement[i + 1].p += frame.placement[i + 1].R * shift[i + 1];
  }
  for (JointModel& joint : frame.joints) {
    joint.frame_a.p_LJ -= shift[index(joint.a)];
    joint.frame_b.p_LJ -= shift[index(joint.b)];
  }
  return frame;
}

}  // namespace clevis::mechanism
