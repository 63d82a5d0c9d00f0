#include "scene/line_elements/read_motor.h"

#include <string>

#include <fmt/format.h>

#include "mechanism/joints/joint_types.h"
#include "scene/element_base/line_source.h"
#include "scene/text/times.h"

namespace clevis::scene {
namespace {

using mechanism::DirectAxis;
using mechanism::MotorLaw;

/// `voltage`, or `voltages` at `times`.
void read_voltage(StrictTable& table, MotorLaw& law) {
  if (const auto constant = table.find("voltage")) {
    law.times = {0.0};
    law.volts = {constant->quantity(Dimension::kVoltage)};
    return;
  }
  if (!table.has("voltages")) {
    throw table.refusal("S003", "lacks the key \"voltage\" or \"voltages\"",
                        "Give one of them.");
  }
  law.times = increasing_times(table["times"], 1);
  const Value voltages = table["voltages"];
  for (const Value& voltage : voltages.elements()) {
    law.volts.push_back(voltage.quantity(Dimension::kVoltage));
  }
  if (law.times.size() != law.volts.size()) {
    throw voltages.refusal("S010",
                           fmt::format("has {} entries for {} times",
                                       law.volts.size(), law.times.size()),
                           "Give one voltage for each time.");
  }
}

}  // namespace

mechanism::LineLaw read_motor(const LineSource& source) {
  StrictTable& table = source.table;
  const mechanism::JointDefinition* joint = source.joint();
  if (joint == nullptr || !mechanism::traits(joint->type).is_hinge()) {
    throw table.refusal("S010", "does not act on a revolute joint",
                        "Name the joint that its shaft or gear turns.");
  }
  constexpr double kMostRatio = 1e5;
  constexpr int kMostPairs = 1000;
  MotorLaw law;
  if (const auto ratio = table.find("ratio")) {
    law.ratio = ratio->number(-kMostRatio, kMostRatio);
    if (law.ratio == 0.0) {
      throw ratio->refusal("S006", "is zero",
                           "Give the turns of the rotor per turn of the "
                           "joint; negative where they turn oppositely.");
    }
  }
  law.pole_pairs = table["pole_pairs"].integer(1, kMostPairs);
  law.resistance = not_negative(table["resistance"], Dimension::kResistance);
  law.inductance = table["inductance"].positive(Dimension::kInductance);
  law.flux = table["flux"].positive(Dimension::kMagneticFlux);
  law.rotor_inertia =
      not_negative_or(table, "rotor_inertia", Dimension::kMassMoment, 0.0);
  read_voltage(table, law);
  if (const auto d_axis = table.find("d_axis")) {
    law.d_axis = d_axis->choice<DirectAxis>(
        {{"decoupled", DirectAxis::kDecoupled}, {"zero", DirectAxis::kZero}});
  }
  return law;
}

}  // namespace clevis::scene
