#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace clevis::multibody {

/// About or along what a joint moves. Units are of an angle where it turns
/// (rad, N m), of a length where it slides (m, N).
struct Axis {
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  ///< unit, in the world
  std::optional<double> lower, upper;                    ///< limits [m, rad]
  double stop_stiffness = 1e8;  ///< of the limits; SDF's default
  double stop_damping = 1.0;    ///< of the limits; SDF's default
  double damping = 0.0;
  double friction = 0.0;  ///< effort, at rest and in motion
  double spring_stiffness = 0.0;
  double spring_reference = 0.0;  ///< where the spring is without effort
};

/// A body as the file has it, where the joints are at zero.
struct Link {
  std::string name;
  Eigen::Vector3d p_WL = Eigen::Vector3d::Zero();  ///< its origin [m]
  Eigen::Matrix3d R_WL = Eigen::Matrix3d::Identity();
  double mass = 0.0;                                      ///< [kg]
  Eigen::Vector3d p_LCm = Eigen::Vector3d::Zero();        ///< [m]
  Eigen::Matrix3d inertia_LCm = Eigen::Matrix3d::Zero();  ///< [kg m²]
  bool is_fixed = false;  ///< part of the ground
};

/// Between two links, where the joints are at zero.
struct Joint {
  std::string name;
  std::string type;                                 ///< the file's word
  std::string parent, child;                        ///< links; empty: the world
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< in the world [m]
  std::vector<Axis> axes;
  double lead = 0.0;  ///< of a screw: slide per turn [m]
};

/// A mechanism as an SDF or URDF file describes it.
struct Model {
  std::string name;
  std::optional<Eigen::Vector3d> gravity;  ///< in the world [m/s²]
  std::vector<Link> links;
  std::vector<Joint> joints;
  std::vector<std::string> told;  ///< what was lost or assumed, a line each
};

}  // namespace clevis::multibody
