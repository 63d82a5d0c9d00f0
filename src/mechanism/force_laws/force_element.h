#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "mechanism/drives/drive_definition.h"
#include "mechanism/force_laws/gas_cylinder.h"
#include "mechanism/force_laws/motor.h"
#include "mechanism/joints/joint_definition.h"
#include "numerics/curves/cubic_spline.h"

namespace clevis::mechanism {

/// A point of a body (−1: ground), in its frame L [m].
struct ElementPoint {
  int body = -1;
  Eigen::Vector3d p_L = Eigen::Vector3d::Zero();
};

/// What an element measures and along which it acts: a joint's coordinate,
/// the distance of two points, or how far point b is from point a along an
/// axis that is fixed in body a. [m] or [rad].
struct ElementLine {
  enum class Kind { kJoint, kDistance, kSlide } kind{};
  int joint = -1;
  int coordinate = 0;  ///< which of the joint's
  ElementPoint a, b;
  Eigen::Vector3d axis_L = Eigen::Vector3d::UnitX();  ///< slide: in L of a
};

/// Effort on b: −stiffness (q − free) − damping q' − preload; > 0 pushes apart.
struct SpringLaw {
  double stiffness{};  ///< [N/m] or [N m/rad]
  double damping{};    ///< [N s/m] or [N m s/rad]
  double free{};       ///< [m] or [rad]
  double preload{};    ///< pull at the free length [N] or [N m]
};

enum class FrictionModel { kCoulomb, kRegularized, kLuGre };

/// Dry friction with stick. Kinetic effort at speed v:
/// kinetic + (breakaway − kinetic) exp(−(v/stribeck)²) + viscous v.
struct FrictionLaw {
  FrictionModel model = FrictionModel::kCoulomb;
  double breakaway{}, kinetic{};  ///< [N] or [N m]
  double viscous{};               ///< [N s/m] or [N m s/rad]
  double stribeck_speed{};        ///< [m/s] or [rad/s]; 0: kinetic at once
  double regularizing_speed{};    ///< of tanh(v/v_c); regularized only
  double bristle_stiffness{}, bristle_damping{};  ///< LuGre
  /// Breakaway and kinetic are per newton of the joint's force across its axis:
  /// [1], or [m] where the joint turns.
  bool follows_reaction = false;
};

enum class ContactModel { kPenalty, kPublished, kHuntCrossley };

/// Normal force of a penetration d > 0 with rate d':
///   penalty    s(d/transition) (k d + b d'), not below 0, s = 3t² − 2t³
///   published  k d + b d', pulls before it lets go
///   Hunt and Crossley  k d^exponent (1 + c d'), not below 0
struct ContactLaw {
  ContactModel model = ContactModel::kPenalty;
  double stiffness{};   ///< [N/m], [N/m^n] or [N m/rad]
  double damping{};     ///< b [N s/m], or c [s/m]
  double transition{};  ///< [m]; 0: full at once
  double exponent = 1.5;
};

/// Unilateral springs at the ends of a line's range.
struct StopLaw {
  std::optional<double> lower, upper;  ///< [m] or [rad]
  ContactLaw contact;
};

/// Effort over time, or over the line's coordinate, linear between the points,
/// constant outside. Two equal times: a step, the later effort from then on.
struct TableLaw {
  std::vector<double> times, efforts;
  std::vector<double> positions{};  ///< [m] or [rad]; then no times
};

/// Follows a reference r(t): effort −stiffness (q − r) − damping (q' − r'), at
/// most `limit`.
struct ServoLaw {
  DriveDefinition reference;    ///< its law; joint and coordinate unused
  double stiffness{};           ///< [N/m] or [N m/rad]
  double damping{};             ///< [N s/m] or [N m s/rad]
  std::optional<double> limit;  ///< [N] or [N m]
};

/// The sense of its line's motion in which an element acts.
enum class ActsOn { kBoth, kIncreasing, kDecreasing };

/// An element with a scalar effort.
struct LineElement {
  std::string name;
  ElementLine line;
  std::variant<SpringLaw, FrictionLaw, StopLaw, TableLaw, GasCylinderLaw,
               MotorLaw, ServoLaw>
      law;
  std::string place;
  ActsOn acts_on = ActsOn::kBoth;  ///< of springs and tables
  /// In that sense its effort grows from nothing at rest to all of it at this
  /// speed; 0: all at once [m/s] or [rad/s].
  double full_speed{};
};

/// A sphere (a wheel, in the plane) on a plane, with regularised friction.
struct ContactElement {
  std::string name;
  ElementPoint center;
  double radius{};  ///< [m]
  ElementPoint plane;
  Eigen::Vector3d normal_L = Eigen::Vector3d::UnitY();  ///< away from it
  ContactLaw law;
  double static_friction{}, kinetic_friction{};  ///< [1]
  double critical_speed = 1e-3;                  ///< [m/s]
  std::string place;
};

/// F = −stiffness (x − x₀) − damping (v − v₀) on a point of a body, from
/// ground; the target x₀ rests or follows splines.
struct ImpedanceElement {
  std::string name;
  ElementPoint point;
  Eigen::Vector3d target_W = Eigen::Vector3d::Zero();  ///< [m]
  std::array<numerics::CubicSpline, 3>
      path_W{};                   ///< by axis, instead; without times none
  double stiffness{}, damping{};  ///< [N/m], [N s/m]
  bool damps_absolute = false;    ///< v₀ = 0 whatever the target does
  std::string place;
};

using ForceElement =
    std::variant<LineElement, ContactElement, ImpedanceElement>;

/// The friction law whose modes events separate, or null.
const FrictionLaw* switched_friction(const ForceElement& element);
/// The law of a table over the line's coordinate, or null.
const TableLaw* position_table(const ForceElement& element);
/// The law of a contact's or stop's normal force, or null.
const ContactLaw* contact_law(const ForceElement& element);
/// The law of a gas cylinder, or null.
const GasCylinderLaw* gas_law(const ForceElement& element);
/// The law of a motor, or null.
const MotorLaw* motor_law(const ForceElement& element);
/// The law of a servo, or null.
const ServoLaw* servo_law(const ForceElement& element);
const std::string& name_of(const ForceElement& element);
/// Whether a line measures an angle.
bool is_angle(const ElementLine& line,
              const std::vector<JointDefinition>& joints);
/// Whether it acts on a body. @param joints  of its mechanism.
bool acts_on(const ForceElement& element,
             const std::vector<JointDefinition>& joints, int body);

}  // namespace clevis::mechanism
