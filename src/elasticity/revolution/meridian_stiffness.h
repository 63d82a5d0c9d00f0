#pragma once

#include <string>
#include <vector>

#include "elasticity/assembly/stiffness.h"
#include "elasticity/fe_space/discretization.h"
#include "part/material.h"

namespace clevis::elasticity {

/// Stiffness of the Fourier terms of a solid of revolution: for amplitudes
/// (u_x, u_+, u_−) at the nodes of its meridian,
/// K_n = wave_norm (A + n B + n² C).
class MeridianStiffness {
 public:
  /// @param meridian  coordinates along the axis and radius, >= 0.
  /// @throws Error M005 if the mapping of a cell is not positive at a point.
  MeridianStiffness(const Discretization<2>& meridian,
                    const part::Material& material, const std::string& place);

  /// K_n of the terms of an order [N/m].
  StiffnessMatrix<3> of_order(int order) const;

 private:
  StiffnessMatrix<3> constant_;
  std::vector<Eigen::Matrix3d> linear_, quadratic_;  ///< like constant_.block
};

/// Nodes on the axis.
std::vector<int> axis_nodes(const Discretization<2>& meridian);

}  // namespace clevis::elasticity
