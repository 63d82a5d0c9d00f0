#pragma once

#include <functional>

#include <Eigen/Core>

namespace clevis::dynamics {

/// X -> A X, all columns as one block.
using BlockOperator = std::function<Eigen::MatrixXd(const Eigen::MatrixXd&)>;

/// M u'' + K u = f without damping, its matrices as operators.
struct LinearSystem {
  Eigen::Index size{};      ///< equations, without those held at zero
  BlockOperator stiffness;  ///< X -> K X [N]
  BlockOperator mass;       ///< X -> M X [kg m]
  /// s -> (B -> (K + s M)⁻¹ B), one factorisation; s [1/s²] > 0, and 0 if no
  /// rigid motion is free.
  std::function<BlockOperator(double shift)> factor;
  /// Free rigid motions, any basis; size × 0…6.
  Eigen::MatrixXd rigid;
  bool is_held = false;  ///< by constraints: K alone may be singular
  /// X -> what constraints leave of X; none: all of it.
  BlockOperator admitted = {};
  /// Square of a circular frequency below the first elastic one but not by
  /// many orders of magnitude, for free parts [1/s²].
  double low_square{};

  /// Of a factor that exists [1/s²].
  double least_shift() const {
    return is_held || rigid.cols() > 0 ? low_square : 0.0;
  }
};

}  // namespace clevis::dynamics
