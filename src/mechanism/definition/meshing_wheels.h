#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "mechanism/definition/definition.h"

namespace clevis::mechanism {

/// Bodies of a coupling whose bearings are on one body, or on bodies that welds
/// join.
struct MeshingWheels {
  BodyIndex wheel_1{}, wheel_2{};  ///< or the rack and its pinion
  BodyIndex carrier_1{}, carrier_2{};
};

/// Nothing if the joints lead to no such carriers, or to several.
std::optional<MeshingWheels> meshing_wheels(
    const std::vector<JointDefinition>& joints,
    const CouplingDefinition& coupling);

/// Pitch circles of wheels with parallel axes; they roll on each other.
struct PitchCircles {
  double distance{};  ///< of the axes [m]
  double to_pitch{};  ///< pitch point from axis 1 towards axis 2 [m]

  /// One wheel is a ring round the other.
  bool is_internal() const { return to_pitch < 0.0 || to_pitch > distance; }
  /// [m]
  double radius_1() const { return std::abs(to_pitch); }
  /// [m]
  double radius_2() const { return std::abs(to_pitch - distance); }
};

/// @pre two revolute joints without tooth_misfit().
PitchCircles pitch_circles(const std::vector<JointDefinition>& joints,
                           const CouplingDefinition& coupling);

/// Why teeth cannot mesh as a coupling says.
struct ToothMisfit {
  std::string what, remedy;
};

/// Nothing if they mesh. @pre the coupling has teeth.
std::optional<ToothMisfit> tooth_misfit(
    const std::vector<JointDefinition>& joints,
    const CouplingDefinition& coupling);

}  // namespace clevis::mechanism
