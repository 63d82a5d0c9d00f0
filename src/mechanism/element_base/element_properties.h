#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "mechanism/drives/drive_definition.h"

namespace clevis::mechanism {

struct GasCylinderLaw;

/// Source of motion of an element's line, where its law alone is: nothing, a
/// force over time, or a machine.
enum class Actuation { kNone, kForce, kMachine };

/// A number that an element adds to its position, rate, effort and power.
struct ElementChannel {
  std::string key;             ///< with its unit: "energy_J"
  bool is_coordinate = false;  ///< [m] or [rad] of its line; key without unit
};

/// Properties of a force element, whatever its kind, for the rest of the
/// program. Each kind fills it in its own file.
struct ElementProperties {
  std::string_view type;  ///< word of scenes and results
  /// Ends press and let go: a contact or a stop.
  bool presses = false;
  Actuation actuation = Actuation::kNone;
  /// Along a slide its effort may stand for a pressure on a piston.
  bool may_be_pressure = false;
  /// Friction per newton of the joint's force.
  bool follows_reaction = false;
  double guide_length = 0.0;  ///< whose ends that force presses; 0: unknown [m]
  /// A contact: slides as well, with a friction of its own.
  bool slides = false;
  std::vector<ElementChannel> channels{};
  /// Efforts over time bend there, and jump at steps [s].
  std::vector<double> breakpoints{}, steps{};
  /// All times at which what is given over time bends [s].
  std::vector<double> breaks{};
  /// Target of its line, or null.
  const DriveDefinition* reference = nullptr;
  /// Paths of a target over time.
  std::vector<const numerics::CubicSpline*> paths{};
  /// A force that is the same at all times, in W [N]; else zero.
  Eigen::Vector3d fixed_force_W = Eigen::Vector3d::Zero();
  /// Ends that press: positions of its line beyond which they do [m] or [rad].
  std::optional<double> lower{}, upper{};
  /// Of what presses: a contact's radius, the range between a stop's ends [m]
  /// or [rad]; 0: not known.
  double size = 0.0;
  std::optional<double> free{};  ///< position without force [m] or [rad]
  /// Of dry friction, at rest, per newton of what presses: [1], or [m] in a
  /// joint that turns.
  double friction = 0.0;
  const GasCylinderLaw* gas = nullptr;  ///< of a gas cylinder, or null
  bool is_motor = false;                ///< its states have a MotorState
};

}  // namespace clevis::mechanism
