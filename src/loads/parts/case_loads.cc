#include "loads/parts/case_loads.h"

#include <fmt/format.h>

#include "loads/history/balance.h"
#include "loads/parts/held_pins.h"
#include "loads/parts/surface_loads.h"

namespace clevis::loads {

LoadHistory case_loads(const part::PartDefinition& part,
                       const part::LoadCaseDefinition& load_case,
                       const std::vector<GroupGeometry>& groups,
                       const part::MassProperties& mass) {
  const std::string place = fmt::format("{}: part {}, case {}", part.place,
                                        part.name, load_case.name);
  LoadHistory history;
  InstantLoad instant;
  instant.label = load_case.name;
  instant.is_case = true;
  instant.rigid = {.acceleration = load_case.acceleration,
                   .alpha = load_case.angular_acceleration,
                   .omega = load_case.angular_velocity};
  for (const auto& [name, force] : load_case.pins) {
    const GroupGeometry& group = find_group(groups, name, place);
    require_cylinder(group, place);
    history.seats.push_back({.name = name,
                             .group = name,
                             .kind = SeatKind::kBearing,
                             .p_LS = group.cylinder.p_LC});
    instant.wrenches.push_back({.force = force});
  }
  instant.surface_loads =
      surface_loads(load_case.pressure, load_case.traction, groups, place);
  for (const auto& [name, components] : load_case.fixed) {
    find_group(groups, name, place);
  }
  for (const auto& [name, foundation] : load_case.foundations) {
    find_group(groups, name, place);
  }
  const double size = part_size(groups, mass);
  if (!load_case.held_by_pin.empty()) {
    hold_by_pins(load_case.held_by_pin, groups, mass, size, place, history,
                 instant);
  }
  if (load_case.fixed.empty() && load_case.foundations.empty()) {
    relieve(history, mass, size,
            fmt::format("{}: part {}", part.place, part.name), instant);
  }
  history.instants.push_back(std::move(instant));
  return history;
}

}  // namespace clevis::loads
