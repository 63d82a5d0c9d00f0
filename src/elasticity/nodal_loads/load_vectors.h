#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "elasticity/fe_space/discretization.h"
#include "elasticity/nodal_loads/load_basis.h"
#include "elasticity/nodal_loads/surface_loads.h"
#include "loads/history/load_history.h"

namespace clevis::elasticity {

/// Consistent nodal loads of every instant as columns (dofs) times
/// coefficients (instants) [N]: what the surfaces need of their own tractions,
/// to 1e-9 of them, and a column per term of the body force
/// −ρ (a + α×p + ω×(ω×p)). For dim = 2 all is integrated through the
/// thickness.
/// @param density [kg/m³].
/// @throws Error see surface_loads.
template <int dim>
SplitLoads load_columns(const Discretization<dim>& discretization,
                        const loads::LoadHistory& history, double density,
                        const std::string& part_name);

/// The same.
/// @param surfaces  as of surface_loads() [N]. @param density [kg/m³].
template <int dim>
SplitLoads load_columns(const Discretization<dim>& discretization,
                        const loads::LoadHistory& history, double density,
                        const std::vector<SurfaceLoads>& surfaces);

/// The same as a field for each instant: dofs × instants [N].
template <int dim>
Eigen::MatrixXd assemble_loads(const Discretization<dim>& discretization,
                               const loads::LoadHistory& history,
                               double density, const std::string& part_name);

/// ∫ N dV of each node, for dim = 2 over the plate's thickness [m³].
template <int dim>
Eigen::VectorXd node_volumes(const Discretization<dim>& discretization);

/// How well loads are in balance: their residual over their size [1].
struct LoadBalance {
  double relief{};  ///< before, largest over the instants
  double rest{};    ///< after
};

/// Balances the discrete loads of a free part at every instant: the
/// interpolated geometry and its quadrature have not quite the exact mass,
/// which leaves a residual that a rigid acceleration of the discrete mass takes
/// up (inertia relief), as columns of its own.
/// @param density [kg/m³].
/// @param modes  rigid modes at the nodes, dofs × modes [1].
template <int dim>
LoadBalance balance_loads(const Discretization<dim>& discretization,
                          double density, const Eigen::MatrixXd& modes,
                          SplitLoads& loads);

/// The same of loads as dofs × instants [N].
/// @return the residual before [1].
template <int dim>
double balance_loads(const Discretization<dim>& discretization, double density,
                     const Eigen::MatrixXd& modes, Eigen::MatrixXd& history);

}  // namespace clevis::elasticity
