#include "scene/element_base/line_source.h"

namespace clevis::scene {
namespace {

double of_a_machine(const Value& value, double stiffness) {
  constexpr double kStiffest = 1e15;  // N/m or N m/rad
  if (stiffness <= kStiffest) return stiffness;
  throw value.refusal("S011", "is stiffer than any machine",
                      "Check the number and its unit.");
}

}  // namespace

const mechanism::JointDefinition* LineSource::joint() const {
  if (line.kind != mechanism::ElementLine::Kind::kJoint) return nullptr;
  return &joints[static_cast<std::size_t>(line.joint)];
}

double not_negative(const Value& value, Dimension dimension) {
  const double number = value.quantity(dimension);
  if (number < 0.0) {
    throw value.refusal("S006", "is negative", "Give zero or more.");
  }
  return number;
}

double plausible_stiffness(const Value& value, Dimension dimension) {
  return of_a_machine(value, value.positive(dimension));
}

double plausible_stiffness_or_zero(const Value& value, Dimension dimension) {
  return of_a_machine(value, not_negative(value, dimension));
}

double not_negative_or(StrictTable& table, std::string_view key,
                       Dimension dimension, double otherwise) {
  const auto value = table.find(key);
  return value ? not_negative(*value, dimension) : otherwise;
}

LineUnits line_units(bool angle) {
  return angle ? LineUnits{Dimension::kAngle, Dimension::kAngularVelocity,
                           Dimension::kTorque, Dimension::kAngularStiffness,
                           Dimension::kAngularDamping}
               : LineUnits{Dimension::kLength, Dimension::kVelocity,
                           Dimension::kForce, Dimension::kStiffness,
                           Dimension::kDamping};
}

}  // namespace clevis::scene
