#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "mechanism/joints/joint_definition.h"

namespace clevis::mechanism {

/// A point of a body (−1: ground), in its frame L [m].
struct ElementPoint {
  int body = -1;
  Eigen::Vector3d p_L = Eigen::Vector3d::Zero();
};

/// Coordinate that an element measures and along which it acts: a joint's,
/// the distance of two points, or how far point b is from point a along an
/// axis that is fixed in body a. [m] or [rad].
struct ElementLine {
  enum class Kind { kJoint, kDistance, kSlide } kind{};
  int joint = -1;
  int coordinate = 0;  ///< which of the joint's
  ElementPoint a, b;
  Eigen::Vector3d axis_L = Eigen::Vector3d::UnitX();  ///< slide: in L of a
};

/// The sense of its line's motion in which an element acts.
enum class ActsOn { kBoth, kIncreasing, kDecreasing };

/// An element with a scalar effort, without its law.
struct LineDefinition {
  std::string name;
  ElementLine line;
  std::string place;
  ActsOn acts_on = ActsOn::kBoth;  ///< of springs and tables
  /// In that sense its effort grows from nothing at rest to all of it at this
  /// speed; 0: all at once [m/s] or [rad/s].
  double full_speed{};
};

/// Whether a line measures an angle.
bool is_angle(const ElementLine& line,
              const std::vector<JointDefinition>& joints);

}  // namespace clevis::mechanism
