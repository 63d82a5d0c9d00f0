#include "scene/motion/read_initial.h"

#include "mechanism/joints/joint_types.h"
#include "scene/text/names.h"

namespace clevis::scene {
namespace {

using mechanism::InitialBodyState;
using mechanism::InitialJointState;
using mechanism::JointDefinition;
using mechanism::JointType;

InitialJointState read_joint_state(StrictTable& table,
                                   const std::vector<JointDefinition>& joints,
                                   Names& names) {
  InitialJointState initial;
  initial.place = table.place();
  const Value joint = table["joint"];
  initial.joint = names.joints.find(joint.name(), joint);
  const JointType type = joints[static_cast<std::size_t>(initial.joint)].type;
  if (mechanism::coordinates(type).size() != 1) {
    throw joint.refusal("S010", "has not one coordinate",
                        "Name a revolute or a prismatic joint, or a body.");
  }
  const bool turns = mechanism::traits(type).is_hinge();
  if (const auto position = table.find("position")) {
    initial.position =
        position->quantity(turns ? Dimension::kAngle : Dimension::kLength);
  }
  if (const auto rate = table.find("rate")) {
    initial.rate = rate->quantity(turns ? Dimension::kAngularVelocity
                                        : Dimension::kVelocity);
  }
  if (!initial.position && !initial.rate) {
    throw table.refusal("S003", "lacks the key \"position\" or \"rate\"",
                        "Give one or both.");
  }
  table.finish("beside \"joint\"");
  return initial;
}

InitialBodyState read_body_state(StrictTable& table, const Names& names) {
  InitialBodyState initial;
  initial.place = table.place();
  const Value body = table["body"];
  initial.body = names.bodies.find(body.name(), body);
  const auto velocity = table.find("velocity");
  if (velocity) initial.v_WLo = velocity->vector(Dimension::kVelocity);
  const auto turn = table.find("angular_velocity");
  if (turn) initial.w_WL = turn->vector(Dimension::kAngularVelocity);
  if (!velocity && !turn) {
    throw table.refusal("S003",
                        "lacks the key \"velocity\" or \"angular_velocity\"",
                        "Give one or both.");
  }
  table.finish("beside \"body\"");
  return initial;
}

}  // namespace

void read_initial_states(StrictTable& root, Names& names,
                         mechanism::MechanismDefinition& mechanism) {
  for (StrictTable& table : root.tables("initial")) {
    if (table.has("joint")) {
      mechanism.initial_joints.push_back(
          read_joint_state(table, mechanism.joints, names));
    } else {
      mechanism.initial_bodies.push_back(read_body_state(table, names));
    }
  }
}

}  // namespace clevis::scene
