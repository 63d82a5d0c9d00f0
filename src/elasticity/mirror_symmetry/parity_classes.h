#pragma once

#include <vector>

#include <Eigen/Core>

#include "elasticity/assembly/equations.h"
#include "elasticity/mirror_symmetry/folding.h"
#include "elasticity/nodal_loads/load_basis.h"
#include "elasticity/problem/refinement.h"
#include "elasticity/problem/self_checks.h"

namespace clevis::elasticity {

/// Of the nodes, dim × nodes [m].
template <int dim>
using Positions = Eigen::Matrix<double, dim, Eigen::Dynamic>;

/// One parity class of the problem on the folded part.
struct ParityClass {
  unsigned parity{};
  LoadBasis loads;
  std::vector<int> held;      ///< on the planes and by supports, sorted
  std::vector<int> supports;  ///< determinate: without reaction
  EquationNumbers numbers;
  Inverse inverse;          ///< by a factor that it keeps
  Eigen::MatrixXd columns;  ///< displacements on the folded part
};

/// Mirrors of the mesh that the supports have too.
/// @param positions  of the nodes [m].
template <int dim>
std::vector<Mirror> common_mirrors(const Discretization<dim>& discretization,
                                   const Positions<dim>& positions,
                                   const std::vector<int>& fixed);

/// The classes that carry load. All have the columns of the whole part's
/// loads, so that the same coefficients go with all of them.
/// @param error  what is left out adds to that of the compression [1].
template <int dim>
std::vector<ParityClass> loaded_classes(const Folding<dim>& folding,
                                        const Positions<dim>& folded_positions,
                                        const LoadBasis& loads, bool is_free,
                                        double& error);

/// Components that a class holds: on the planes, by the fixed supports of the
/// whole part, or determinate where it is free.
/// @param folded_positions  of the folded part's nodes [m].
template <int dim>
void hold(const Folding<dim>& folding, const std::vector<int>& fixed,
          const Positions<dim>& folded_positions, ParityClass& parity_class);

/// @return strain energy per instant [J].
Eigen::VectorXd check_classes(const StiffnessAction& stiffness,
                              const std::vector<ParityClass>& classes,
                              double images, const LoadBasis& loads,
                              SolveChecks& checks);

}  // namespace clevis::elasticity
