#include "scene/parts/read_force_seats.h"

#include <algorithm>

#include <fmt/format.h>

#include "mechanism/joints/joint_types.h"
#include "scene/text/names.h"
#include "scene/text/suggestion.h"

namespace clevis::scene {
namespace {

using mechanism::BodyIndex;
using mechanism::ForceElement;
using mechanism::MechanismDefinition;

/// The element of a name. @pre there is one.
const ForceElement& element_of(const std::string& name,
                               const MechanismDefinition& mechanism) {
  return *std::ranges::find_if(mechanism.elements, [&](const ForceElement& e) {
    return mechanism::name_of(e) == name;
  });
}

/// Whether the effort on a piston is a pressure: of gas, or as a table says.
bool has_pressure(const ForceElement& element,
                  const MechanismDefinition& mechanism) {
  return mechanism::properties(element).may_be_pressure &&
         !mechanism::is_angle(element, mechanism.joints);
}

void read_pressurized(StrictTable& entry, const ForceElement& element,
                      const MechanismDefinition& mechanism,
                      part::ForceSeat& seat) {
  const auto pressurized = entry.find("pressurized");
  if (!pressurized) return;
  if (!has_pressure(element, mechanism)) {
    throw pressurized->refusal("S010", "of a force without pressure",
                               "Only a gas cylinder, or a table that slides, "
                               "puts walls under pressure.");
  }
  for (const Value& group : pressurized->elements()) {
    seat.pressurized.push_back(group.text());
  }
  const auto* gas = mechanism::properties(element).gas;
  if (gas == nullptr) return;
  if (gas->chambers.size() == 1) {
    seat.chamber = gas->chambers.front().name;
    if (!entry.has("chamber")) return;
  }
  const Value chamber = entry["chamber"];
  seat.chamber = chamber.text();
  std::vector<std::string_view> known;
  for (const auto& c : gas->chambers) known.push_back(c.name);
  if (std::ranges::find(known, seat.chamber) == known.end()) {
    throw chamber.refusal(
        "S007", fmt::format("names no chamber: \"{:.64}\"", seat.chamber),
        suggestion(seat.chamber, known));
  }
}

}  // namespace

void read_force_seats(StrictTable& table, BodyIndex body,
                      const MechanismDefinition& mechanism, const Names& names,
                      part::PartDefinition& part) {
  const auto forces = table.find("forces");
  if (!forces) return;
  for (const auto& [name, value] : forces->entries()) {
    names.forces.find(name, value);
    const ForceElement& element = element_of(name, mechanism);
    if (!mechanism::acts_on(element, mechanism.joints, body)) {
      throw value.refusal(
          "S010",
          fmt::format("is a force on other bodies than \"{}\"",
                      mechanism.bodies[static_cast<std::size_t>(body)].name),
          "Give the forces on the body that has this part.");
    }
    StrictTable entry(value, "part.forces");
    part::ForceSeat seat{name, entry["face"].text(), {}};
    read_pressurized(entry, element, mechanism, seat);
    entry.finish("without a gas cylinder's pressurized walls");
    part.force_seats.push_back(seat);
  }
}

}  // namespace clevis::scene
