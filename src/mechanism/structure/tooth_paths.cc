#include "mechanism/structure/tooth_paths.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace clevis::mechanism {
namespace {

using Bodies = std::vector<BodyIndex>;

/// Place in a list of the ground and the bodies behind it.
std::size_t at(BodyIndex body) {
  return static_cast<std::size_t>(body - kGround);
}

/// Bodies, ground among them, that hang together with some without one.
std::vector<bool> reached(const MechanismDefinition& definition,
                          const std::vector<bool>& passes, const Bodies& from,
                          BodyIndex without) {
  std::vector<bool> found(definition.bodies.size() + 1, false);
  Bodies ends;
  const auto take = [&](BodyIndex body) {
    if (body == without || found[at(body)]) return;
    found[at(body)] = true;
    ends.push_back(body);
  };
  for (const BodyIndex body : from) take(body);
  while (!ends.empty()) {
    const BodyIndex end = ends.back();
    ends.pop_back();
    for (std::size_t j = 0; j < passes.size(); ++j) {
      const JointDefinition& joint = definition.joints[j];
      if (!passes[j]) continue;
      if (joint.body_a == end) take(joint.body_b);
      if (joint.body_b == end) take(joint.body_a);
    }
  }
  return found;
}

/// Joints on the ways between some bodies that pass no body twice: what
/// balances itself on these bodies loads no other joint.
/// @param passes  the joints that hand it on.
std::vector<bool> joints_between(const MechanismDefinition& definition,
                                 std::vector<bool> passes,
                                 const Bodies& bodies) {
  std::vector<bool> between = passes;
  const auto count = static_cast<BodyIndex>(definition.bodies.size());
  for (BodyIndex without = kGround; without < count; ++without) {
    const auto found = reached(definition, passes, bodies, without);
    for (std::size_t j = 0; j < passes.size(); ++j) {
      const JointDefinition& joint = definition.joints[j];
      // Behind one body alone nothing leads on.
      if (!found[at(joint.body_a)] && !found[at(joint.body_b)]) {
        between[j] = false;
      }
    }
  }
  return between;
}

/// Whether a joint hands on all forces and moments but along its own axis.
bool holds_across(JointType type) {
  return type == JointType::kRevolute || type == JointType::kPrismatic ||
         type == JointType::kCylindrical || type == JointType::kScrew;
}

bool is_unique(const Motion& motion, std::size_t joint) {
  return std::ranges::all_of(motion.instants, [joint](const Instant& instant) {
    return instant.joints[joint].unique;
  });
}

/// Whether the teeth's forces are in the reactions.
bool is_resolved(const Motion& motion, std::size_t coupling) {
  return !motion.instants.empty() &&
         std::ranges::all_of(motion.instants, [coupling](const auto& instant) {
           const CouplingState& state = instant.couplings[coupling];
           return state.teeth && state.unique;
         });
}

bool share_a_body(const JointDefinition& one, const JointDefinition& other) {
  return one.body_a == other.body_a || one.body_a == other.body_b ||
         one.body_b == other.body_a || one.body_b == other.body_b;
}

}  // namespace

std::vector<std::size_t> joints_without_teeth(
    const MechanismDefinition& definition, const Motion& motion,
    std::size_t index) {
  const CouplingDefinition& coupling = definition.couplings[index];
  if (coupling.teeth && is_resolved(motion, index)) return {};
  const std::array coupled{static_cast<std::size_t>(coupling.joint_1),
                           static_cast<std::size_t>(coupling.joint_2)};
  const JointDefinition& one = definition.joints[coupled[0]];
  const JointDefinition& other = definition.joints[coupled[1]];
  const bool carry_all = std::ranges::all_of(coupled, [&](std::size_t joint) {
    return holds_across(definition.joints[joint].type) &&
           is_unique(motion, joint);
  });
  std::vector<bool> lack(definition.joints.size(), false);
  if (!carry_all || !share_a_body(one, other)) {
    std::vector<bool> passes(definition.joints.size(), true);
    for (const std::size_t joint : coupled) passes[joint] = !carry_all;
    lack = joints_between(definition, std::move(passes),
                          {one.body_a, one.body_b, other.body_a, other.body_b});
  }
  for (const std::size_t joint : coupled) lack[joint] = true;
  std::vector<std::size_t> joints;
  for (std::size_t j = 0; j < lack.size(); ++j) {
    if (lack[j]) joints.push_back(j);
  }
  return joints;
}

}  // namespace clevis::mechanism
