#include "mechanism/structure/assur_inputs.h"

#include <algorithm>

#include "mechanism/structure/assur.h"
#include "mechanism/structure/constraint_shares.h"
#include "mechanism/structure/link_graph.h"

namespace clevis::mechanism {
namespace {

/// The joint that an actuator moves, or -1.
int actuated_joint(const ForceElement& element) {
  const auto* line = std::get_if<LineElement>(&element);
  if (line == nullptr || line->line.kind != ElementLine::Kind::kJoint) {
    return -1;
  }
  const auto* table = std::get_if<TableLaw>(&line->law);
  const bool acts = std::holds_alternative<MotorLaw>(line->law) ||
                    std::holds_alternative<ServoLaw>(line->law) ||
                    std::holds_alternative<GasCylinderLaw>(line->law) ||
                    (table != nullptr && !table->times.empty());
  return acts ? line->line.joint : -1;
}

/// Actuated joints (motors and the like before forces over time), joints on
/// ground, all others.
std::vector<int> candidates(const MechanismDefinition& definition) {
  std::vector<int> joints, forced, others;
  for (const ForceElement& element : definition.elements) {
    const int joint = actuated_joint(element);
    if (joint < 0) continue;
    const bool is_force =
        std::holds_alternative<TableLaw>(std::get<LineElement>(element).law);
    (is_force ? forced : joints).push_back(joint);
  }
  joints.insert(joints.end(), forced.begin(), forced.end());
  for (const LinkGraph::Pair& pair : link_graph(definition, {}).pairs) {
    const bool on_ground = pair.a == kGround || pair.b == kGround;
    (on_ground ? joints : others).push_back(pair.joint);
  }
  joints.insert(joints.end(), others.begin(), others.end());
  return joints;
}

}  // namespace

std::vector<int> taken_inputs(const MechanismDefinition& definition,
                              int count) {
  std::vector<int> locked, taken;
  for (const DriveDefinition& drive : definition.drives) {
    locked.push_back(drive.joint);
  }
  // what no set of links refuses by its count can be completed, joint by
  // joint, to one that leaves no freedom
  for (const int joint : candidates(definition)) {
    if (static_cast<int>(taken.size()) >= count) break;
    if (std::ranges::find(locked, joint) != locked.end()) continue;
    locked.push_back(joint);
    if (constraint_shares(link_graph(definition, locked))) {
      taken.push_back(joint);
    } else {
      locked.pop_back();
    }
  }
  return taken;
}

}  // namespace clevis::mechanism
