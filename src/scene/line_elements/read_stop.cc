#include "scene/line_elements/read_stop.h"

#include "scene/element_base/read_contact_law.h"

namespace clevis::scene {

mechanism::LineLaw read_stop(const LineSource& source) {
  StrictTable& table = source.table;
  const LineUnits units = source.units();
  mechanism::StopLaw law;
  if (const auto lower = table.find("lower")) {
    law.lower = lower->quantity(units.coordinate);
  }
  if (const auto upper = table.find("upper")) {
    law.upper = upper->quantity(units.coordinate);
    if (law.lower && *law.upper <= *law.lower) {
      throw upper->refusal("S006", "is not above lower",
                           "Leave room between the stops.");
    }
  }
  if (!law.lower && !law.upper) {
    throw table.refusal("S003", "lacks the key \"lower\" or \"upper\"",
                        "Give one or both ends.");
  }
  law.contact = read_contact_law(table, units);
  return law;
}

}  // namespace clevis::scene
