#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "elasticity/assembly/foundation.h"
#include "elasticity/fe_space/discretization.h"
#include "part/supports.h"

namespace clevis::elasticity {

/// Number of rigid-body modes.
template <int dim>
inline constexpr int kRigidModes = dim == 2 ? 3 : 6;

/// Positions of all nodes [m], dim × nodes.
template <int dim>
Eigen::Matrix<double, dim, Eigen::Dynamic> node_positions(
    const Discretization<dim>& discretization);

/// Rigid modes at the nodes [1]: translations, then rotations about `centre`
/// [m] over `length` [m] (so that all columns have like size); dofs × modes.
template <int dim>
Eigen::MatrixXd rigid_modes(
    const Eigen::Matrix<double, dim, Eigen::Dynamic>& positions,
    const Eigen::Matrix<double, dim, 1>& centre, double length);

/// As many displacement components as rigid modes, at vertices chosen by
/// pivoted QR of the modes so that the support is as well conditioned as the
/// mesh allows. Loads in balance leave them without reaction.
/// @param positions  of the nodes [m].
template <int dim>
std::vector<int> determinate_supports(
    const Discretization<dim>& discretization,
    const Eigen::Matrix<double, dim, Eigen::Dynamic>& positions);

/// The same for some of the rigid modes, with some components held already.
/// @param modes  those that are still free, dofs × modes [1].
/// @param held   sorted.
/// @return as many components as modes, sorted.
template <int dim>
std::vector<int> determinate_supports(const Discretization<dim>& discretization,
                                      const Eigen::MatrixXd& modes,
                                      const std::vector<int>& held);

/// Components held at zero on groups (a case's `fixed`), sorted; whether they
/// hold the part is not asked.
template <int dim>
std::vector<int> held_on_groups(const Discretization<dim>& discretization,
                                const part::Supports& fixed);

/// The same of a part that they must hold.
/// @param positions  of the nodes [m].
/// @param bed  holds the part too; or null.
/// @throws Error F001 naming the free mode if they leave the part loose.
template <int dim>
std::vector<int> fixed_supports(
    const Discretization<dim>& discretization,
    const Eigen::Matrix<double, dim, Eigen::Dynamic>& positions,
    const part::Supports& fixed, const std::string& place,
    const FoundationStiffness<dim>* bed = nullptr);

}  // namespace clevis::elasticity
