#pragma once

#include <string>

#include <Eigen/Core>

#include "dynamics/systems/linear_system.h"

namespace clevis::dynamics {

/// Free vibrations K φ = ω² M φ, lowest first, the rigid motions before them.
struct Modes {
  Eigen::VectorXd squares;  ///< ω², 0 for rigid motions [1/s²]
  Eigen::MatrixXd shapes;   ///< φᵀ M φ = 1, size × modes
  int rigid{};              ///< how many are rigid
  /// ‖(K + s M)⁻¹ M φ − φ/(ω² + s)‖_M (ω² + s): distance of ω² + s to an
  /// eigenvalue of the matrices, relative [1]; of the shape about the same
  /// over the relative gap.
  Eigen::VectorXd residual;
  /// |φᵀ K φ/φᵀ M φ − ω²| over ω² + s: K and M as they are, not factored [1].
  Eigen::VectorXd rayleigh_error;
  Eigen::Index space{};  ///< vectors that were needed
};

/// The lowest modes by shift and invert, rigid ones counted in.
/// @param name  for messages ("part DCE").
/// @param tolerance  of the residual; eigenvalues have its square [1].
/// @throws Error F003 if a mode does not satisfy its equation, F002.
Modes lowest_modes(const LinearSystem& system, int count,
                   const std::string& name, double tolerance = 1e-9);

}  // namespace clevis::dynamics
