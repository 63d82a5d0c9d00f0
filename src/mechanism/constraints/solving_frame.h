#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "mechanism/constraints/tooth_mesh.h"
#include "mechanism/definition/definition.h"
#include "mechanism/joints/configuration.h"

namespace clevis::mechanism {

/// Compliance of a joint along each axis where the user gives none [m/N].
inline constexpr double kDefaultCompliance = 1e-9;

/// q_1 = ratio q_2 + offset between coordinates of two joints.
struct CouplingModel {
  int joint_1{}, joint_2{};
  JointRow row_1, row_2;
  double ratio{}, offset{};
  double scale{};  ///< makes its row comparable with lengths
  std::optional<ToothMesh> teeth = std::nullopt;
};

/// Compliance of a link, its points relative to its joints.
struct ElasticLink {
  int slot{};
  std::vector<int> joints;
  std::vector<Eigen::Vector3d> points;  ///< from J on the link, in L [m]
  Eigen::MatrixXd root;       ///< rootᵀ root = LinkCompliance::matrix
  Eigen::MatrixXd spin_root;  ///< rootᵀ spin_root = LinkCompliance::by_spin
  std::vector<LinkLoad> loads;
  Eigen::MatrixXd load_root;  ///< rootᵀ load_root = LinkCompliance::by_load
};

/// A mechanism in the frame P in which it is solved: for planar ones z is the
/// plane's normal. Each body is referred to M, the mean of its joints.
struct SolvingFrame : ReferenceFrame {
  explicit SolvingFrame(const MechanismDefinition& definition);

  bool planar{};
  bool is_tree{};  ///< no joint closes a loop
  /// Characteristic link length [m]. Rotations are scaled by it so that all
  /// unknowns are lengths.
  double length{};
  std::vector<CouplingModel> couplings;
  std::vector<ElasticLink> links;  ///< those that are not rigid
  Configuration placement;         ///< as the user gave it, out of plane closed

  /// Part of the largest singular value of the joints' rows that counts as
  /// zero [1]. The rows of a tree never depend on one another, unless couplings
  /// or drives repeat themselves; but they are far from one length where a
  /// slide leads far away.
  double rank_threshold() const;
};

}  // namespace clevis::mechanism
