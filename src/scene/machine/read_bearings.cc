#include "scene/machine/read_bearings.h"

#include <fmt/format.h>

#include "machine/bearings/bearing_history.h"
#include "mechanism/joints/joint_types.h"
#include "scene/text/names.h"

namespace clevis::scene {
namespace {

using machine::AxialFactors;
using machine::BearingDefinition;
using machine::BearingKind;

constexpr double kLargestFactor = 100.0;

int read_joint(StrictTable& table,
               const std::vector<mechanism::JointDefinition>& joints,
               const Names& names) {
  const Value joint = table["joint"];
  const int index = names.joints.find(joint.name(), joint);
  const auto& found = joints[static_cast<std::size_t>(index)];
  if (!mechanism::traits(found.type).takes_bearing) {
    throw joint.refusal("S010",
                        fmt::format("names joint {}, which is {}", found.name,
                                    mechanism::name_of(found.type)),
                        "A bearing sits in a revolute or cylindrical joint.");
  }
  return index;
}

/// X, Y and e, all or none.
void read_dynamic_factors(StrictTable& table, BearingDefinition& bearing) {
  if (!table.has("radial_factor") && !table.has("axial_factor") &&
      !table.has("axial_threshold")) {
    return;
  }
  AxialFactors factors;
  factors.X = table["radial_factor"].number(0.0, kLargestFactor);
  factors.Y = table["axial_factor"].number(0.0, kLargestFactor);
  factors.threshold = table["axial_threshold"].number(0.0, kLargestFactor);
  bearing.dynamic_factors = factors;
}

/// X0 and Y0, both or none.
void read_static_factors(StrictTable& table, BearingDefinition& bearing) {
  if (!table.has("static_radial_factor") && !table.has("static_axial_factor")) {
    return;
  }
  AxialFactors factors;
  factors.X = table["static_radial_factor"].number(0.0, kLargestFactor);
  factors.Y = table["static_axial_factor"].number(0.0, kLargestFactor);
  bearing.static_factors = factors;
}

void read_size(StrictTable& table, BearingDefinition& bearing) {
  const auto length = [&table](std::string_view key) {
    const auto value = table.find(key);
    return value ? value->positive(Dimension::kLength) : 0.0;
  };
  bearing.bore = length("bore");
  bearing.outer_diameter = length("outer_diameter");
  bearing.width = length("width");
  if (table.has("bore") && table.has("outer_diameter") &&
      bearing.outer_diameter <= bearing.bore) {
    throw table["outer_diameter"].refusal(
        "S006", "is not above the bore",
        "Give the diameters of the catalogue.");
  }
}

BearingDefinition read_bearing(
    StrictTable& table, const std::vector<mechanism::JointDefinition>& joints,
    Names& names) {
  constexpr double kLeastSafety = 0.1;
  BearingDefinition bearing;
  bearing.place = table.place();
  bearing.joint = read_joint(table, joints, names);
  const auto name = table.find("name");
  bearing.name = name ? name->name()
                      : joints[static_cast<std::size_t>(bearing.joint)].name;
  names.bearings.add(bearing.name, name ? *name : table["joint"]);
  bearing.kind = table["kind"].choice<BearingKind>(
      {{"ball", BearingKind::kBall}, {"roller", BearingKind::kRoller}});
  bearing.dynamic_rating = table["dynamic_rating"].positive(Dimension::kForce);
  bearing.static_rating = table["static_rating"].positive(Dimension::kForce);
  read_dynamic_factors(table, bearing);
  read_static_factors(table, bearing);
  if (const auto factor = table.find("service_factor")) {
    bearing.service_factor = factor->number(1.0, kLargestFactor);
  }
  if (const auto life = table.find("life_wanted")) {
    bearing.life_wanted = life->positive(Dimension::kTime);
  }
  if (const auto safety = table.find("static_safety_wanted")) {
    bearing.static_safety_wanted = safety->number(kLeastSafety, kLargestFactor);
  }
  read_size(table, bearing);
  return bearing;
}

}  // namespace

std::vector<BearingDefinition> read_bearings(
    StrictTable& root, const std::vector<mechanism::JointDefinition>& joints,
    Names& names) {
  std::vector<BearingDefinition> bearings;
  for (StrictTable& table : root.tables("bearing")) {
    bearings.push_back(read_bearing(table, joints, names));
  }
  return bearings;
}

}  // namespace clevis::scene
