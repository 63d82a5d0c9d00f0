#include "loads/seats/force_seats.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "base/messages/errors.h"
#include "loads/history/balance.h"
#include "loads/seats/part_seats.h"
#include "loads/seats/seat_fit.h"

namespace clevis::loads {

using Eigen::Vector3d;
using mechanism::ElementLine;
using mechanism::ForceElement;

namespace {

const std::string kForceSeat = "force ";

/// Finds the force among those that act on the body.
/// @return whether there is one.
bool find_force(const SeatContext& context, const std::string& name,
                ForceSeat& result) {
  const auto& elements = context.definition.elements;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (mechanism::name_of(elements[i]) != name ||
        !mechanism::acts_on(elements[i], context.definition.joints,
                            context.body)) {
      continue;
    }
    result.index = i;
    return true;
  }
  return false;
}

void find_chamber(const ForceElement& element, const part::ForceSeat& wanted,
                  ForceSeat& result) {
  const mechanism::GasCylinderLaw* gas = mechanism::properties(element).gas;
  if (gas == nullptr) return;
  result.environment = gas->environment.pressure;
  const auto chamber = std::ranges::find(gas->chambers, wanted.chamber,
                                         &mechanism::GasChamber::name);
  if (chamber == gas->chambers.end()) return;  // the first
  result.chamber = static_cast<std::size_t>(chamber - gas->chambers.begin());
}

ForceSeat force_seat(const SeatContext& context,
                     const part::ForceSeat& wanted) {
  const std::string place = context.place(force_seat_name(wanted.force));
  ForceSeat result;
  if (!find_force(context, wanted.force, result)) {
    throw Error("L004", place,
                fmt::format("force \"{}\" does not act on the body of the part",
                            wanted.force),
                "Name a force on this body, or delete the entry.");
  }
  const GroupGeometry& group = find_group(context.groups, wanted.group, place);
  result.area = group.area;
  result.seat = {.name = force_seat_name(wanted.force),
                 .group = wanted.group,
                 .kind = SeatKind::kPressure,
                 .p_LS = group.centroid};
  const ForceElement& element = context.definition.elements[result.index];
  const ElementLine* line = line_of(element);
  if (closes_about_pin(group)) {
    result.seat.kind = SeatKind::kBearing;
    result.seat.p_LS = group.cylinder.p_LC;
    if (line != nullptr && line->kind == ElementLine::Kind::kJoint) {
      require_coaxial(context, group.cylinder, line->joint, wanted.group,
                      place);
    }
  }
  find_chamber(element, wanted, result);
  result.pressurized = pressurized_groups(context, wanted.pressurized, place);
  return result;
}

}  // namespace

std::string force_seat_name(const std::string& force) {
  return kForceSeat + force;
}

bool is_force_seat(const Seat& seat) {
  return seat.name.starts_with(kForceSeat);
}

void require_force_seats(const SeatContext& context) {
  const auto require = [&](const std::string& name, const std::string& place) {
    if (std::ranges::find(context.part.force_seats, name,
                          &part::ForceSeat::force) !=
        context.part.force_seats.end()) {
      return;
    }
    throw Error("L004", place,
                fmt::format("force \"{}\" acts on the body of part {}, but "
                            "on no surface of it",
                            name, context.part.name),
                fmt::format("Add to the part: forces = {{ \"{}\" = {{ face = "
                            "\"GROUP\" }} }}, the bore or face that takes it.",
                            name));
  };
  for (const ForceElement& element : context.definition.elements) {
    if (mechanism::acts_on(element, context.definition.joints, context.body)) {
      require(name_of(element), place_of(element));
    }
  }
}

std::vector<ForceSeat> force_seats(const SeatContext& context) {
  std::vector<ForceSeat> seats;
  for (const part::ForceSeat& wanted : context.part.force_seats) {
    seats.push_back(force_seat(context, wanted));
  }
  return seats;
}

Wrench force_on(const SeatContext& context, const mechanism::Instant& instant,
                const ForceSeat& seat) {
  const auto& pose =
      instant.bodies[static_cast<std::size_t>(context.body)].pose;
  const Eigen::Matrix3d R_LW = pose.R_WL.transpose();
  for (const auto& action : instant.elements[seat.index].actions) {
    if (action.body != context.body) continue;
    return about(R_LW * action.f_W, R_LW * action.t_W,
                 R_LW * (action.p_W - pose.p_WL), seat.seat.p_LS);
  }
  assert(false && "the element acts on this body");
  return {};
}

double pressure_of(const mechanism::Instant& instant, const ForceSeat& seat) {
  const mechanism::ElementState& state = instant.elements[seat.index];
  if (state.chambers.empty()) {
    return std::max(0.0, state.effort) / seat.area;
  }
  return state.chambers[seat.chamber].pressure - seat.environment;
}

}  // namespace clevis::loads
