#include "mechanism/reactions/largest_reaction.h"

#include <algorithm>
#include <cstddef>
#include <map>

namespace clevis::mechanism {
namespace {

double size_of(const JointReaction& reaction, double length) {
  return std::max(reaction.f_W.norm(), reaction.t_W.norm() / length);
}

}  // namespace

double largest_reaction(const Motion& motion, double length) {
  double largest = 0.0;
  for (const Instant& instant : motion.instants) {
    for (const JointReaction& joint : instant.joints) {
      largest = std::max(largest, size_of(joint, length));
    }
  }
  return largest;
}

std::vector<double> reactions_beside(const std::vector<JointDefinition>& joints,
                                     const Motion& motion, double length) {
  constexpr double kRoundOff = 1e-6;  // of the motion's, beside what is little
  if (joints.empty()) return {};
  std::vector<double> of_joints(joints.size(), 0.0);
  for (const Instant& instant : motion.instants) {
    for (std::size_t j = 0; j < joints.size(); ++j) {
      of_joints[j] = std::max(of_joints[j], size_of(instant.joints[j], length));
    }
  }
  std::map<BodyIndex, double> of_bodies;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    for (const BodyIndex body : {joints[j].body_a, joints[j].body_b}) {
      double& largest = of_bodies[body];
      largest = std::max(largest, of_joints[j]);
    }
  }
  const double of_motion = *std::ranges::max_element(of_joints);
  std::vector<double> beside;
  for (const JointDefinition& joint : joints) {
    double least = of_motion;
    for (const BodyIndex body : {joint.body_a, joint.body_b}) {
      if (body != kGround) least = std::min(least, of_bodies[body]);
    }
    beside.push_back(std::max(least, kRoundOff * of_motion));
  }
  return beside;
}

}  // namespace clevis::mechanism
