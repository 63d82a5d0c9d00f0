#include "scene/cases/read_cases.h"

#include <algorithm>

#include <fmt/format.h>

#include "scene/cases/read_supports.h"
#include "scene/text/name_index.h"

namespace clevis::scene {
namespace {

using part::LoadCaseDefinition;
using part::Probe;

std::string read_quantity_name(const Value& value) {
  return value.choice<std::string>({{"von_mises", "von_mises"},
                                    {"stress_xx", "stress_xx"},
                                    {"stress_yy", "stress_yy"},
                                    {"stress_zz", "stress_zz"},
                                    {"stress_xy", "stress_xy"},
                                    {"stress_xz", "stress_xz"},
                                    {"stress_yz", "stress_yz"},
                                    {"displacement_x", "displacement_x"},
                                    {"displacement_y", "displacement_y"},
                                    {"displacement_z", "displacement_z"}});
}

std::vector<Probe> read_probes(StrictTable& table) {
  std::vector<Probe> probes;
  NameIndex names("probe");
  for (StrictTable& entry : table.tables("probes")) {
    const Value name = entry["name"];
    names.add(name.name(), name);
    Probe probe{name.name(), entry["at"].vector(Dimension::kLength),
                read_quantity_name(entry["quantity"])};
    if (const auto reference = entry.find("reference")) {
      probe.reference = reference->quantity(
          part::is_displacement(probe.quantity) ? Dimension::kLength
                                                : Dimension::kStress);
    }
    probes.push_back(std::move(probe));
  }
  return probes;
}

Eigen::Vector3d vector_or_zero(StrictTable& table, std::string_view key,
                               Dimension dimension) {
  const auto value = table.find(key);
  return value ? value->vector(dimension) : Eigen::Vector3d::Zero();
}

void require_load(const StrictTable& table) {
  constexpr std::string_view kLoads[] = {"pins",
                                         "pressure",
                                         "traction",
                                         "acceleration",
                                         "gravity",
                                         "angular_velocity",
                                         "angular_acceleration"};
  if (std::ranges::none_of(kLoads, [&](auto key) {
        return table.has(key);
      })) {
    throw table.refusal("S003", "has no load",
                        "Give pins, pressure, traction, gravity or an "
                        "acceleration.");
  }
}

}  // namespace

LoadCaseDefinition read_case(StrictTable table) {
  const auto force = [](const Value& v) {
    return v.vector(Dimension::kForce);
  };
  const auto stress = [](const Value& v) {
    return v.vector(Dimension::kStress);
  };
  const auto pressure = [](const Value& v) {
    return v.quantity(Dimension::kStress);
  };
  LoadCaseDefinition load_case;
  load_case.name = table["name"].title();
  require_load(table);
  load_case.pins = read_groups<Eigen::Vector3d>(table, "pins", force);
  load_case.pressure = read_groups<double>(table, "pressure", pressure);
  load_case.traction = read_groups<Eigen::Vector3d>(table, "traction", stress);
  load_case.fixed = read_fixed(table);
  load_case.foundations = read_foundations(table);
  load_case.held_by_pin = read_held_by_pin(table, [&](const Value& element) {
    if (!load_case.pins.contains(element.text())) return;
    throw element.refusal(
        "S010", fmt::format("holds \"{}\", which `pins` loads", element.text()),
        "A pin either holds the part, by a reaction that is found, or "
        "loads it by a force that is given.");
  });
  load_case.acceleration =
      vector_or_zero(table, "acceleration", Dimension::kAcceleration) -
      vector_or_zero(table, "gravity", Dimension::kAcceleration);
  load_case.angular_velocity =
      vector_or_zero(table, "angular_velocity", Dimension::kAngularVelocity);
  load_case.angular_acceleration = vector_or_zero(
      table, "angular_acceleration", Dimension::kAngularAcceleration);
  load_case.probes = read_probes(table);
  return load_case;
}

}  // namespace clevis::scene
