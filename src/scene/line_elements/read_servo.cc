#include "scene/line_elements/read_servo.h"

#include <numbers>

#include "scene/element_base/line_source.h"
#include "scene/motion/read_drives.h"

namespace clevis::scene {
namespace {

using mechanism::ServoLaw;

/// `stiffness` and `damping`, or what `bandwidth` and `damping_ratio` make of
/// the `inertia` that it moves.
void read_gains(StrictTable& table, const LineUnits& units, Dimension inertia,
                ServoLaw& law) {
  constexpr double kMostDamped = 100.0;
  if (table.has("stiffness")) {
    law.stiffness = plausible_stiffness(table["stiffness"], units.stiffness);
    law.damping = not_negative_or(table, "damping", units.damping, 0.0);
    return;
  }
  if (!table.has("bandwidth")) {
    throw table.refusal("S003", "lacks the key \"stiffness\" or \"bandwidth\"",
                        "Give the gains, or the bandwidth with the inertia "
                        "that it moves.");
  }
  const double speed = 2.0 * std::numbers::pi *
                       table["bandwidth"].positive(Dimension::kFrequency);
  const double moved = table["inertia"].positive(inertia);
  const auto ratio = table.find("damping_ratio");
  law.stiffness = moved * speed * speed;
  law.damping =
      2.0 * (ratio ? ratio->number(0.0, kMostDamped) : 1.0) * moved * speed;
}

}  // namespace

mechanism::LineLaw read_servo(const LineSource& source) {
  StrictTable& table = source.table;
  if (source.joint() == nullptr) {
    throw table.refusal("S010", "acts between points",
                        "A servo moves the coordinate of a joint.");
  }
  const LineUnits units = source.units();
  const Dimension inertia =
      source.is_angle() ? Dimension::kMassMoment : Dimension::kMass;
  ServoLaw law;
  law.reference.place = table.place();
  read_drive_law(table, units.coordinate, law.reference);
  read_gains(table, units, inertia, law);
  if (const auto limit = table.find("limit")) {
    law.limit = limit->positive(units.effort);
  }
  return law;
}

}  // namespace clevis::scene
