#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "mechanism/drives/drive_definition.h"
#include "mechanism/force_elements/force_element.h"
#include "mechanism/joints/joint_definition.h"
#include "numerics/integrators/integrator_choice.h"
#include "part/mass_properties.h"
#include "part/pose.h"

namespace clevis::mechanism {

using part::Pose;

/// A force element that strains a link beside its joints.
struct LinkLoad {
  int element{};          ///< index into MechanismDefinition::elements
  Eigen::Vector3d point;  ///< p_LS, where the link takes it [m]
};

/// Compliance of a link at its joints: displacements and turns at `points` per
/// force [N] and moment about the point [N m] there, in L, beside those of
/// its rigid motion. Its loads are held by its inertia.
struct LinkCompliance {
  std::vector<int> joints;              ///< indices
  std::vector<Eigen::Vector3d> points;  ///< p_LS, one per joint [m]
  Eigen::MatrixXd matrix;  ///< 6 n × 6 n, symmetric: force, then moment
  /// 6 n × 6: the same displacements by a spin ω, per ω_x², ω_y², ω_z², ω_x
  /// ω_y, ω_x ω_z and ω_y ω_z in L [m s²], [s²]; empty: none.
  Eigen::MatrixXd by_spin = {};
  std::vector<LinkLoad> loads = {};
  /// 6 n × 6 m: the same displacements by each load's force [N] and moment
  /// about its point [N m], in L.
  Eigen::MatrixXd by_load = {};
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

/// Teeth of two wheels with parallel axes, or of a rack and its pinion, whose
/// bearings one body carries.
struct ToothGeometry {
  double pressure_angle{};  ///< of the normal section [rad]
  double helix_angle{};     ///< > 0: the wheel of joint 1 is right-handed [rad]
  /// Middle of the face width, from the point of joint 1, or of the pinion's
  /// joint, along its axis [m]; nothing: both joints have their points there.
  std::optional<double> mid_face;
};

/// Gear or rack: q_1 = ratio q_2 + offset between coordinates of two joints.
struct CouplingDefinition {
  std::string name;
  int joint_1{}, coordinate_1{};
  int joint_2{}, coordinate_2{};
  double ratio{};                ///< unit of q_1 per unit of q_2
  std::optional<double> offset;  ///< without: that of the placement
  /// Without, the tooth force is not resolved: each coordinate takes its
  /// generalised force.
  std::optional<ToothGeometry> teeth = std::nullopt;
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

/// Compliances that share the reactions which equilibrium leaves open: of the
/// joints on rigid links, or of the links as well.
enum class LinkStiffness { kRigid, kElastic };

enum class SpaceDimension { kAuto, kPlanar, kSpatial };

/// A mechanism as the user wrote it, indices resolved. Immutable after
/// reading.
struct MechanismDefinition {
  std::vector<BodyDefinition> bodies;
  std::vector<JointDefinition> joints;
  std::vector<CouplingDefinition> couplings;
  std::vector<DriveDefinition> drives;
  std::vector<ForceElement> elements;
  std::vector<MarkerDefinition> markers;
  std::vector<InitialJointState> initial_joints;
  std::vector<InitialBodyState> initial_bodies;
  Eigen::Vector3d gravity_W = Eigen::Vector3d::Zero();  ///< [m/s²]
  SpaceDimension dimension = SpaceDimension::kAuto;
};

/// Origin of a motion: from the drives alone, or by integration of the
/// equations of motion. kAuto: the latter if the drives leave freedom.
enum class MotionKind { kAuto, kDriven, kDynamic };

/// Policy where the motion passes a change point.
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
  numerics::IntegratorChoice integrator = numerics::IntegratorChoice::kAuto;
  /// Also where loads are largest or jump: their peaks are looked for between
  /// the uniform instants.
  bool at_peaks = false;
  double max_time = 60.0;  ///< of the processor, for a motion [s]
  AtSingularity at_singularity = AtSingularity::kReport;
  LinkStiffness links = LinkStiffness::kRigid;
  /// Joints whose seats travel along parts: looked at all along their way.
  std::vector<int> slides = {};
  /// Told how much of an integration is done [1], every few steps; or empty.
  std::function<void(double share)> progress = {};
};

}  // namespace clevis::mechanism
