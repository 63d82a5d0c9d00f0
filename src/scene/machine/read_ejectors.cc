#include "scene/machine/read_ejectors.h"

#include "scene/element_base/line_source.h"
#include "scene/text/names.h"

namespace clevis::scene {
namespace {

using machine::EjectorDefinition;

void read_workpiece(StrictTable table,
                    const std::vector<part::Material>& materials,
                    const Names& names, EjectorDefinition& ejector) {
  const Value material = table["material"];
  ejector.workpiece = materials[static_cast<std::size_t>(
      names.materials.find(material.name(), material))];
  ejector.diameter = table["diameter"].positive(Dimension::kLength);
  ejector.length = table["length"].positive(Dimension::kLength);
  constexpr double kLeast = 1e-3, kMost = 1e3;
  if (const auto factor = table.find("safety_factor")) {
    ejector.safety_factor = factor->number(kLeast, kMost);
  }
  constexpr double kSlender = 2.0;
  if (ejector.length < kSlender * ejector.diameter) {
    throw table["length"].refusal(
        "S006", "is less than twice the diameter",
        "Beam theory has nothing to say of so short a workpiece: check it as "
        "a [[part]].");
  }
}

EjectorDefinition read_ejector(StrictTable& table,
                               const std::vector<part::Material>& materials,
                               Names& names) {
  EjectorDefinition ejector;
  ejector.place = table.place();
  const Value name = table["name"];
  ejector.name = name.title();
  names.ejectors.add(ejector.name, name);
  ejector.arm_magnet = table["arm_magnet"].positive(Dimension::kLength);
  ejector.arm_pusher = table["arm_pusher"].positive(Dimension::kLength);
  ejector.arm_spring = table["arm_spring"].positive(Dimension::kLength);
  ejector.inertia = table["inertia"].positive(Dimension::kMassMoment);
  ejector.magnet_force = table["magnet_force"].positive(Dimension::kForce);
  ejector.magnet_range = table["range"].positive(Dimension::kLength);
  const Value travel = table["travel"];
  ejector.travel = travel.positive(Dimension::kLength);
  if (ejector.travel > ejector.magnet_range) {
    throw travel.refusal("S006", "is above the magnet's range",
                         "Beyond its range the magnet has no force.");
  }
  ejector.spring_stiffness = plausible_stiffness_or_zero(
      table["spring_stiffness"], Dimension::kStiffness);
  ejector.spring_preset =
      not_negative(table["spring_preset"], Dimension::kLength);
  read_workpiece(table.table("workpiece"), materials, names, ejector);
  return ejector;
}

}  // namespace

std::vector<EjectorDefinition> read_ejectors(
    StrictTable& root, const std::vector<part::Material>& materials,
    Names& names) {
  std::vector<EjectorDefinition> ejectors;
  for (StrictTable& table : root.tables("ejector")) {
    ejectors.push_back(read_ejector(table, materials, names));
  }
  return ejectors;
}

}  // namespace clevis::scene
