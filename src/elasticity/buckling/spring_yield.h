#pragma once

#include <vector>

#include <Eigen/Core>

#include "elasticity/buckling/buckling_problem.h"

namespace clevis::elasticity {

/// What springs of the mechanism yield where loads push a part over that is
/// rigid: 1/λ of S Sᵀ φ = λ F φ, S the springs and F what the loads bring, over
/// the motions that the mechanism leaves.
class SpringYield {
 public:
  /// @param problem  outlives the object.
  /// @param rigid    motions of the part, dofs × motions.
  /// @throws Error see seat_means().
  SpringYield(const BucklingProblem& problem, const Eigen::MatrixXd& rigid);

  /// Instants at which it is asked for, evenly over all; none: nothing springs.
  const std::vector<Eigen::Index>& instants() const { return instants_; }
  /// 1/λ; 0: its loads do not push it over [1].
  /// @param form  F of the rigid motions at the instant.
  double at(Eigen::Index instant, const Eigen::MatrixXd& form) const;

 private:
  const loads::LoadHistory& history_;
  std::vector<Eigen::Index> instants_;
  Eigen::MatrixXd motions_;  ///< of the seats, six each × rigid motions
};

}  // namespace clevis::elasticity
