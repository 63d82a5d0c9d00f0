#pragma once

#include <optional>
#include <string>

#include <Eigen/Core>

namespace clevis::mechanism {

/// Index of a body; ground is kGround.
using BodyIndex = int;
inline constexpr BodyIndex kGround = -1;

enum class JointType {
  kRevolute,
  kPrismatic,
  kWeld,
  kCylindrical,
  kUniversal,
  kSpherical,
  kPlanar,
  kScrew,
  kDistance,
  kPointOnLine
};

/// Frame J of a joint on one of its bodies: z is the joint axis (rotation,
/// slide, normal of a planar joint), x the direction that prismatic and weld
/// joints keep aligned and from which angles about z are measured.
struct JointFrame {
  Eigen::Vector3d p_LJ = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Matrix3d R_LJ = Eigen::Matrix3d::Identity();
};

/// Compliance of a joint in frame J, per force [m/N] and per moment
/// [rad/(N m)] along x, y, z. It decides how reactions are shared that
/// equilibrium leaves open, and bounds them at change points; motion stays
/// that of rigid joints.
struct JointCompliance {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
};

/// A joint between bodies a and b, J its frame on each. Coordinates (named in
/// joint_types.h): angles from x of a to x of b about z [rad], distances from
/// the origin of a's frame to b's along an axis of a [m]. A universal joint
/// turns about z of a, then about x of b, which stay at right angles; angles
/// of a spherical one are about z of a, the turned x, y of b.
struct JointDefinition {
  std::string name;
  JointType type{};
  BodyIndex body_a = kGround;
  BodyIndex body_b = kGround;
  JointFrame frame_a, frame_b;
  std::string place;
  double lead{};    ///< of a screw: slide along z per turn [m]
  double length{};  ///< of a distance joint: between the origins [m]
  std::optional<JointCompliance> compliance = std::nullopt;
};

}  // namespace clevis::mechanism
