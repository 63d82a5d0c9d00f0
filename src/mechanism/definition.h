#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "mechanism/drive_definition.h"
#include "mechanism/force_element.h"
#include "part/mass_properties.h"

namespace clevis::mechanism {

/// Index of a body; ground is kGround.
using BodyIndex = int;
inline constexpr BodyIndex kGround = -1;

/// Position and orientation of frame L in frame W.
struct Pose {
  Eigen::Vector3d p_WL = Eigen::Vector3d::Zero();      ///< [m]
  Eigen::Matrix3d R_WL = Eigen::Matrix3d::Identity();  ///< columns: axes of L
};

/// How a link gives way at its joints: displacements and turns at `points`
/// per force [N] and moment about the point [N m] there, in L, beside those of
/// its rigid motion. Its loads are held by its inertia.
struct LinkCompliance {
  std::vector<int> joints;              ///< indices
  std::vector<Eigen::Vector3d> points;  ///< p_LS, one per joint [m]
  Eigen::MatrixXd matrix;  ///< 6 n × 6 n, symmetric: force, then moment
};

/// A rigid body. Its frame L is the frame of its part, if it has one.
struct BodyDefinition {
  std::string name;
  std::string part;  ///< name of its part, or empty
  part::MassProperties mass_properties;
  /// Approximate pose in the reference configuration; assembly closes loops.
  Pose placement;
  std::string place;  ///< file:line:column
  /// Shares reactions that equilibrium leaves open; the body moves as a rigid
  /// one.
  std::optional<LinkCompliance> compliance = std::nullopt;
  bool is_placed = true;  ///< false: the scene gives no placement
};

enum class JointType {
  kRevolute,
  kPrismatic,
  kWeld,
  kCylindrical,
  kUniversal,
  kSpherical,
  kPlanar,
  kScrew,
  kDistance
};

/// Frame J of a joint on one of its bodies: z is the joint axis (rotation,
/// slide, normal of a planar joint), x the direction that prismatic and weld
/// joints keep aligned and from which angles about z are measured.
struct JointFrame {
  Eigen::Vector3d p_LJ = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Matrix3d R_LJ = Eigen::Matrix3d::Identity();
};

/// How far a joint gives way in frame J, per force [m/N] and per moment
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

/// Gear or rack: q_1 = ratio q_2 + offset between coordinates of two joints.
/// The tooth force is not resolved: each coordinate takes its generalised
/// force.
struct CouplingDefinition {
  std::string name;
  int joint_1{}, coordinate_1{};
  int joint_2{}, coordinate_2{};
  double ratio{};                ///< unit of q_1 per unit of q_2
  std::optional<double> offset;  ///< without: that of the placement
  std::string place;
};

/// A constant force and moment on a body, directions fixed in W.
struct ForceDefinition {
  std::string name;
  BodyIndex body{};
  Eigen::Vector3d p_LP = Eigen::Vector3d::Zero();  ///< point of attack in L [m]
  Eigen::Vector3d f_W = Eigen::Vector3d::Zero();   ///< [N]
  Eigen::Vector3d t_W = Eigen::Vector3d::Zero();   ///< [N m]
  std::string place;
};

/// Coordinate or rate of a joint at t = 0, of motions that are integrated.
struct InitialJointState {
  int joint{};                     ///< index into MechanismDefinition::joints
  std::optional<double> position;  ///< [m] or [rad]
  std::optional<double> rate;      ///< [m/s] or [rad/s]
  std::string place;
};

/// Velocity of a body at t = 0, as near as the joints allow.
struct InitialBodyState {
  BodyIndex body{};
  Eigen::Vector3d v_WLo = Eigen::Vector3d::Zero();  ///< [m/s]
  Eigen::Vector3d w_WL = Eigen::Vector3d::Zero();   ///< [rad/s], in W
  std::string place;
};

/// A point of a body whose path is an output.
struct MarkerDefinition {
  std::string name;
  BodyIndex body{};
  Eigen::Vector3d p_LP = Eigen::Vector3d::Zero();  ///< [m]
};

/// What shares the reactions that equilibrium leaves open: joints that give
/// way on rigid links, or the links as well.
enum class LinkStiffness { kRigid, kElastic };

enum class SpaceDimension { kAuto, kPlanar, kSpatial };

/// A mechanism as the user wrote it, indices resolved. Immutable after
/// reading.
struct MechanismDefinition {
  std::vector<BodyDefinition> bodies;
  std::vector<JointDefinition> joints;
  std::vector<CouplingDefinition> couplings;
  std::vector<DriveDefinition> drives;
  std::vector<ForceDefinition> forces;
  std::vector<ForceElement> elements;
  std::vector<MarkerDefinition> markers;
  std::vector<InitialJointState> initial_joints;
  std::vector<InitialBodyState> initial_bodies;
  Eigen::Vector3d gravity_W = Eigen::Vector3d::Zero();  ///< [m/s²]
  SpaceDimension dimension = SpaceDimension::kAuto;
};

/// How a motion comes about: from the drives alone, or by integration of the
/// equations of motion. kAuto: the latter if the drives leave freedom.
enum class MotionKind { kAuto, kDriven, kDynamic };

/// Method of an integrated motion: DOP853, Radau IIA, or each where it is the
/// better.
enum class IntegratorChoice { kAuto, kExplicit, kImplicit };

/// What happens where the motion passes a change point.
enum class AtSingularity {
  kReport,    ///< it keeps its branch; an instant just there is refused
  kContinue,  ///< that instant gets the reactions of joints that give way
  kStop       ///< the first change point is refused
};

/// When the motion is sampled.
struct SimulationSettings {
  double duration{};   ///< [s]
  int instants = 201;  ///< uniform from 0 to duration, both included
  /// Closure, and the error of integrated positions, over the mechanism's
  /// size.
  double tolerance = 1e-8;
  MotionKind motion = MotionKind::kAuto;
  IntegratorChoice integrator = IntegratorChoice::kAuto;
  /// Also where loads are largest or jump: their peaks are looked for between
  /// the uniform instants.
  bool at_peaks = false;
  AtSingularity at_singularity = AtSingularity::kReport;
  LinkStiffness links = LinkStiffness::kRigid;
};

}  // namespace clevis::mechanism
