#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "mechanism/constraints/constraint_system.h"

namespace clevis::mechanism {

/// Velocities v that joints allow where J has lost rank, to second order.
///
/// J v = 0 leaves more freedom than the mechanism has. An acceleration with
/// J a + b(v, v) = 0 exists only if wᵀ b(v, v) = 0 for all w with wᵀ J = 0:
/// the velocities of the branches that meet here. Those near v on its branch
/// satisfy wᵀ b(v, u) = 0. A position within kRankThreshold counts as
/// singular. Velocities are of the unknowns of ConstraintSystem [m/s].
/// Source: docs/theory.md, "Change points".
class SingularPosition {
 public:
  /// @param joints  system without drives; outlives this.
  SingularPosition(const ConstraintSystem& joints, const Configuration& x);

  /// Freedom of first order: at least that of every branch.
  int freedom() const { return static_cast<int>(velocities_.cols()); }

  /// Velocities of branches that move by `rates` along `rows`, found from many
  /// starts; two of them differ by more than 2 %. Empty: no branch does.
  /// @param rows   by row the motion per unknown, e.g. of drives.
  /// @param rates  not all zero.
  std::vector<Eigen::VectorXd> velocities(const Eigen::MatrixXd& rows,
                                          const Eigen::VectorXd& rates) const;

  /// Orthonormal velocities of the branch of v.
  Eigen::MatrixXd tangents(const Eigen::VectorXd& v) const;

 private:
  Eigen::VectorXd second_order(const Eigen::VectorXd& y) const;
  Eigen::MatrixXd second_order_change(const Eigen::VectorXd& y) const;

  double length_;
  Eigen::MatrixXd velocities_;          ///< orthonormal columns with J v = 0
  std::vector<Eigen::MatrixXd> forms_;  ///< length wᵀ b, of coefficients
};

/// A position on one branch through a singular position.
struct BranchPoint {
  Configuration x;
  Eigen::MatrixXd tangents;  ///< columns: velocities of the branch
  /// Change of `tangents` per unknowns' velocity `along` of a motion.
  Eigen::MatrixXd slopes;
  Eigen::MatrixXd coordinates;  ///< coordinatesᵀ tangents = 1, constant
};

/// The point of the branch nearest to a singular position, and its tangents,
/// by interpolation between regular positions on both sides: so they are as
/// exact as those, where J itself leaves them open.
/// @param x      closed within round-off or some part of kRankThreshold.
/// @param along  a velocity of the branch [m/s]; `slopes` is for its size.
/// @param freedom  of the mechanism.
/// @return nothing if no regular branch leads there on both sides.
std::optional<BranchPoint> branch_point(const ConstraintSystem& joints,
                                        const Configuration& x,
                                        const Eigen::VectorXd& along,
                                        int freedom);

}  // namespace clevis::mechanism
