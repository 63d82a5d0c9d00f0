#include "mechanism/definition/pitch_radii.h"

#include <cmath>

#include "mechanism/definition/meshing_wheels.h"

namespace clevis::mechanism {

std::vector<double> pitch_radii(const std::vector<JointDefinition>& joints,
                                const CouplingDefinition& coupling) {
  const auto first = static_cast<std::size_t>(coupling.joint_1);
  if (joints[first].type == JointType::kPrismatic) {
    return {std::abs(coupling.ratio)};
  }
  const PitchCircles circles = pitch_circles(joints, coupling);
  return {circles.radius_1(), circles.radius_2()};
}

}  // namespace clevis::mechanism
