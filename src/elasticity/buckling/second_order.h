#pragma once

#include <vector>

#include <Eigen/Core>

#include "elasticity/buckling/buckling_problem.h"

namespace clevis::elasticity {

/// Displacements under the loads of an instant with one hold.
struct SecondOrder {
  Eigen::Index instant{};
  Eigen::VectorXd linear;  ///< K u = f, as the hold has them, dofs [m]
  /// (K + K_G − Ω² M) u = f: the stresses of the linear ones, and the spin, act
  /// on what is displaced.
  Eigen::VectorXd second;
  bool is_stable{};  ///< else the part buckles, or whirls, under less
};

/// Of every instant of the history and every hold. The stresses K_G are those
/// of linear theory, the loads keep size and direction, and the part spins
/// about where its frame has it.
/// @throws Error as of lowest_buckling().
std::vector<SecondOrder> second_order(const BucklingProblem& problem);

}  // namespace clevis::elasticity
