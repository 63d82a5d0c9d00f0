#include "scene/parts/read_impacts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "scene/cases/read_supports.h"
#include "scene/element_base/line_source.h"
#include "scene/text/names.h"

namespace clevis::scene {
namespace {

using part::ImpactDefinition;

/// The name of a contact or stop of the mechanism.
std::string read_contact_name(const Value& value,
                              const mechanism::MechanismDefinition& mechanism,
                              const Names& names) {
  const std::string name = value.title();
  names.forces.find(name, value);
  const auto found = std::ranges::find_if(
      mechanism.elements, [&](const mechanism::ForceElement& element) {
        return name_of(element) == name;
      });
  if (found == mechanism.elements.end() ||
      !mechanism::properties(*found).presses) {
    throw value.refusal("S010", "is neither a contact nor a stop",
                        "Name a force of type \"contact\" or \"stop\", or "
                        "give mass and speed.");
  }
  return name;
}

void read_striker(StrictTable& table,
                  const mechanism::MechanismDefinition& mechanism,
                  const Names& names, ImpactDefinition& impact) {
  if (const auto contact = table.find("contact")) {
    impact.contact = read_contact_name(*contact, mechanism, names);
    return;
  }
  impact.mass = table["mass"].positive(Dimension::kMass);
  const Value speed = table["speed"];
  impact.speed = speed.quantity(Dimension::kVelocity);
  constexpr double kSound = 5000.0;  // [m/s], in steel
  if (impact.speed > 0.1 * kSound) {
    throw speed.refusal("S011", "is beyond what stays elastic",
                        "Give a speed below 500 m/s.");
  }
  if (const auto force = table.find("force")) {
    impact.force = force->quantity(Dimension::kForce);
  }
  if (impact.speed > 0.0 || (impact.speed == 0.0 && impact.force > 0.0)) return;
  throw speed.refusal("S011", "brings no striker to the part",
                      "Give a speed above zero, or zero with a force that "
                      "presses.");
}

/// Nothing (an ideal velocity step), a linear spring, or Hertz's for a ball of
/// the part's material on a flat face: 4/3 E/(2 (1 − ν²)) √R.
void read_spring(StrictTable& table, const part::Material& material,
                 ImpactDefinition& impact) {
  if (const auto radius = table.find("ball_radius")) {
    const double nu = material.poissons_ratio;
    const double modulus = material.youngs_modulus / (2.0 * (1.0 - nu * nu));
    impact.stiffness =
        4.0 / 3.0 * modulus * std::sqrt(radius->positive(Dimension::kLength));
    impact.exponent = 1.5;
    return;
  }
  const Value stiffness = table["stiffness"];
  impact.stiffness =
      stiffness.text() == "ideal"
          ? std::numeric_limits<double>::infinity()
          : plausible_stiffness(stiffness, Dimension::kStiffness);
}

}  // namespace

std::vector<ImpactOfPart> read_impacts(
    StrictTable& root, const mechanism::MechanismDefinition& mechanism,
    Names& names) {
  std::vector<ImpactOfPart> impacts;
  NameIndex known("impact");
  for (StrictTable& table : root.tables("impact")) {
    const Value part = table["part"];
    ImpactOfPart entry{.part = names.parts.find(part.name(), part),
                       .table = std::move(table)};
    const Value name = entry.table["name"];
    ImpactDefinition& impact = entry.impact;
    impact.name = name.title();
    known.add(impact.name, name);
    impact.place = entry.table.place();
    impact.group = entry.table["face"].text();
    impact.direction = entry.table["direction"].direction();
    impact.fixed = read_fixed(entry.table);
    if (impact.fixed.empty()) {
      throw entry.table.refusal("S003", "lacks the key \"fixed\"",
                                "Say what holds the part: fixed = { root = "
                                "[\"x\", \"y\", \"z\"] }.");
    }
    read_striker(entry.table, mechanism, names, impact);
    if (const auto duration = entry.table.find("duration")) {
      impact.duration = duration->positive(Dimension::kTime);
    }
    impacts.push_back(std::move(entry));
  }
  return impacts;
}

void add_impacts(std::vector<ImpactOfPart>& impacts, int index,
                 part::PartDefinition& part) {
  for (ImpactOfPart& entry : impacts) {
    if (entry.part != index) continue;
    read_spring(entry.table, part.material, entry.impact);
    entry.table.finish("beside contact or ball_radius");
    part.impacts.push_back(entry.impact);
  }
}

}  // namespace clevis::scene
