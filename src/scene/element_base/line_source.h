#pragma once

#include <string_view>
#include <vector>

#include "mechanism/definition/definition.h"
#include "scene/text/names.h"
#include "scene/text/strict_table.h"

namespace clevis::scene {

/// A quantity [SI] that may be zero but not negative. @throws Error S006.
double not_negative(const Value& value, Dimension dimension);
double not_negative_or(StrictTable& table, std::string_view key,
                       Dimension dimension, double otherwise);

/// A stiffness above zero that some machine has: a cube of steel of 10 m has
/// 2e12 N/m. In [N/m] or [N m/rad]. @throws Error S006, S011.
double plausible_stiffness(const Value& value, Dimension dimension);
/// The same [N/m] or [N m/rad], or zero.
double plausible_stiffness_or_zero(const Value& value, Dimension dimension);

/// Dimensions of a line's coordinate, effort and constants.
struct LineUnits {
  Dimension coordinate, rate, effort, stiffness, damping;
};

LineUnits line_units(bool angle);

/// The table of an element along a line, and its line.
struct LineSource {
  StrictTable& table;
  const mechanism::ElementLine& line;
  const std::vector<mechanism::JointDefinition>& joints;
  const Names& names;

  bool is_angle() const { return mechanism::is_angle(line, joints); }
  LineUnits units() const { return line_units(is_angle()); }
  /// Joint whose coordinate it measures, or null.
  const mechanism::JointDefinition* joint() const;
};

}  // namespace clevis::scene
