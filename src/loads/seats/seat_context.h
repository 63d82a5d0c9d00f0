#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "loads/history/group_geometry.h"
#include "loads/history/load_history.h"
#include "mechanism/definition/definition.h"
#include "part/part_definition.h"

namespace clevis::loads {

/// Input from which the seats of a part are found.
struct SeatContext {
  const mechanism::MechanismDefinition& definition;
  mechanism::BodyIndex body;
  const part::PartDefinition& part;
  const std::vector<GroupGeometry>& groups;
  double size;  ///< of the part [m]

  /// "file:line:column: part NAME, seat" for messages.
  std::string place(const std::string& seat) const;
};

/// A joint of the body, its frame there and the sign of its reaction.
struct BodyJoint {
  std::size_t index{};
  const mechanism::JointDefinition* definition = nullptr;
  const mechanism::JointFrame* frame = nullptr;
  double sign{};  ///< +1 if the body is b, -1 if it is a
};

struct JointSeat {
  BodyJoint joint;
  Seat seat;
};

struct DrivenSeat {
  BodyJoint joint;
  std::size_t drive{};  ///< index into MechanismDefinition::drives
  bool turns{};         ///< its effort is a torque
  Seat seat;
  double area{};  ///< of the face [m²]
  std::vector<GroupGeometry> pressurized;
};

}  // namespace clevis::loads
