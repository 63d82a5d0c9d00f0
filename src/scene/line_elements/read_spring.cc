#include "scene/line_elements/read_spring.h"

namespace clevis::scene {

mechanism::LineLaw read_spring(const LineSource& source) {
  StrictTable& table = source.table;
  const LineUnits units = source.units();
  mechanism::SpringLaw law;
  if (const auto stiffness = table.find("stiffness")) {
    law.stiffness = plausible_stiffness_or_zero(*stiffness, units.stiffness);
  }
  law.damping = not_negative_or(table, "damping", units.damping, 0.0);
  if (!table.has("stiffness") && !table.has("damping")) {
    throw table.refusal("S003", "lacks the key \"stiffness\" or \"damping\"",
                        "Give a spring, a damper or both.");
  }
  // of a stiffness of zero it means nothing, but may stand
  const bool of_zero = table.has("stiffness") && table.has("free");
  if (law.stiffness > 0.0 || of_zero) {
    law.free = table["free"].quantity(units.coordinate);
  }
  if (const auto preload = table.find("preload")) {
    law.preload = preload->quantity(units.effort);
  }
  if (law.stiffness == 0.0 && law.damping == 0.0 && law.preload == 0.0) {
    throw table.refusal(
        "S006",
        "has neither stiffness nor damping nor preload: all are "
        "zero",
        "Give one above zero, or remove the force.");
  }
  return law;
}

}  // namespace clevis::scene
