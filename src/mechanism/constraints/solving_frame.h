#pragma once

#include <vector>

#include <Eigen/Core>

#include "mechanism/definition/definition.h"
#include "mechanism/joints/joint_model.h"

namespace clevis::mechanism {

/// Compliance of a joint along each axis where the user gives none [m/N].
inline constexpr double kDefaultCompliance = 1e-9;

/// Positions of all bodies by slot; slot 0 is ground. Joints that count turns
/// also need the angle that they have turned by.
struct Configuration : std::vector<BodyPlacement> {
  using std::vector<BodyPlacement>::vector;
  /// By joint, to half a turn [rad]; move() keeps it up. Empty: all 0.
  std::vector<double> angles;

  double angle(std::size_t joint) const {
    return joint < angles.size() ? angles[joint] : 0.0;
  }
};

/// q_1 = ratio q_2 + offset between coordinates of two joints.
struct CouplingModel {
  int joint_1{}, joint_2{};
  JointRow row_1, row_2;
  double ratio{}, offset{};
  double scale{};  ///< makes its row comparable with lengths
};

/// Compliance of a link, its points relative to its joints.
struct ElasticLink {
  int slot{};
  std::vector<int> joints;
  std::vector<Eigen::Vector3d> points;  ///< from J on the link, in L [m]
  Eigen::MatrixXd root;  ///< rootᵀ root = LinkCompliance::matrix
};

/// A mechanism in the frame P in which it is solved: for planar ones z is the
/// plane's normal. Each body is referred to M, the mean of its joints.
struct SolvingFrame {
  explicit SolvingFrame(const MechanismDefinition& definition);

  bool planar{};
  bool is_tree{};  ///< no joint closes a loop
  Eigen::Matrix3d R_WP = Eigen::Matrix3d::Identity();
  /// Lengths of the links' order [m]: turns are measured as turn × length.
  double length{};
  std::vector<Eigen::Vector3d> p_LM;  ///< by body [m]
  std::vector<JointModel> joints;
  std::vector<CouplingModel> couplings;
  std::vector<ElasticLink> links;  ///< those that are not rigid
  Configuration placement;         ///< as the user gave it, out of plane closed

  /// Part of the largest singular value of the joints' rows that counts as
  /// zero. The rows of a tree never depend on one another, unless couplings or
  /// drives repeat themselves; but they are far from one length where a slide
  /// leads far away.
  double rank_threshold() const;
};

}  // namespace clevis::mechanism
