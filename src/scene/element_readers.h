#pragma once

#include "scene/readers.h"

namespace clevis::scene {

/// A quantity that may be zero but not negative. @throws Error S006.
double not_negative(const Value& value, Dimension dimension);
double not_negative_or(StrictTable& table, std::string_view key,
                       Dimension dimension, double otherwise);

/// A stiffness above zero that some machine has: a cube of steel of 10 m has
/// 2e12 N/m. @throws Error S006, S011.
double plausible_stiffness(const Value& value, Dimension dimension);
/// The same, or zero.
double plausible_stiffness_or_zero(const Value& value, Dimension dimension);

/// Dimensions of a line's coordinate, effort and constants.
struct LineUnits {
  Dimension coordinate, rate, effort, stiffness, damping;
};

LineUnits line_units(bool angle);

// The keys of one type of force each; all throw Error S002–S011.
mechanism::StopLaw read_stop(StrictTable& table, const LineUnits& units);
/// @param angle  whether its line turns: refused.
mechanism::GasCylinderLaw read_gas_cylinder(StrictTable& table, bool angle);
/// @param on_revolute  whether its line is a revolute joint's angle, else
///   refused.
mechanism::MotorLaw read_motor(StrictTable& table, bool on_revolute);
/// @param inertia  its dimension on this line.
mechanism::ServoLaw read_servo(StrictTable& table, const LineUnits& units,
                               Dimension inertia);
mechanism::ContactElement read_contact(StrictTable& table, const Names& names);
mechanism::ImpedanceElement read_impedance(StrictTable& table,
                                           const Names& names);

}  // namespace clevis::scene
