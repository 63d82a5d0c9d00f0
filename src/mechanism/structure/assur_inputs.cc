#include "mechanism/structure/assur_inputs.h"

#include <algorithm>

#include "mechanism/structure/assur.h"
#include "mechanism/structure/freedom_orientation.h"
#include "mechanism/structure/link_graph.h"

namespace clevis::mechanism {
namespace {

/// Actuated joints (motors and the like before forces over time), joints on
/// ground, all others.
std::vector<int> candidates(const MechanismDefinition& definition) {
  std::vector<int> joints, forced, others;
  for (const ForceElement& element : definition.elements) {
    const ElementLine* line = line_of(element);
    if (line == nullptr || line->kind != ElementLine::Kind::kJoint) continue;
    const Actuation actuation = properties(element).actuation;
    if (actuation == Actuation::kMachine) joints.push_back(line->joint);
    if (actuation == Actuation::kForce) forced.push_back(line->joint);
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

std::vector<int> assumed_inputs(const MechanismDefinition& definition,
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
    if (freedom_orientation(link_graph(definition, locked))) {
      taken.push_back(joint);
    } else {
      locked.pop_back();
    }
  }
  return taken;
}

}  // namespace clevis::mechanism
