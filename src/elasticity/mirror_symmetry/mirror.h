#pragma once

#include <vector>

#include <Eigen/Core>

#include "elasticity/fe_space/discretization.h"

namespace clevis::elasticity {

/// A reflection x_axis → 2 position − x_axis that maps the mesh to itself.
struct Mirror {
  int axis{};
  double position{};         ///< of the plane [m]
  double tolerance{};        ///< within which nodes are taken as paired [m]
  std::vector<int> partner;  ///< node → its image
};

/// The coordinate planes through the middle of the part's box about which the
/// mesh is symmetric: node by node to 1e-9 of its size, cell by cell, with no
/// cell across the plane. Material is uniform, so the stiffness is symmetric
/// too.
/// @param positions  of the nodes [m].
template <int dim>
std::vector<Mirror> find_mirrors(
    const Discretization<dim>& discretization,
    const Eigen::Matrix<double, dim, Eigen::Dynamic>& positions);

/// Whether a set of degrees of freedom (sorted) is its own image.
template <int dim>
bool maps_to_itself(const Mirror& mirror, const std::vector<int>& dofs);

}  // namespace clevis::elasticity
