#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "dynamics/systems/linear_system.h"
#include "elasticity/assembly/equations.h"
#include "elasticity/fe_space/discretization.h"
#include "elasticity/problem/displacement_basis.h"
#include "elasticity/problem/elastic_problem.h"

namespace clevis::elasticity {

/// Stiffness and consistent mass of a part as a linear system in the equations
/// that are not held.
template <int dim>
struct VibratingPart {
  Discretization<dim> discretization;
  EquationNumbers numbers;
  /// Of a part without supports the mechanism holds seats in the mean and adds
  /// mass to them (neighbour_hold.h).
  dynamics::LinearSystem system;
  dynamics::LinearSystem free;  ///< the same without what holds or springs
  Eigen::MatrixXd held;         ///< equations × held directions
  /// Springs and dampers of the mechanism that hold it besides, equations ×
  /// their directions [√(N/m)], [√(N s/m)].
  Eigen::MatrixXd sprung, damped;
  /// Equations of other bodies that springs swing, behind the part's own.
  Eigen::Index bodies = 0;
  double mass{};  ///< of the discrete part [kg]
};

/// Of its supports and beds alone; its loads are not asked for.
/// @param degree   of the displacement, 1…4 (simplices 1…2).
/// @throws Error F001, F002, F004, M005.
template <int dim>
VibratingPart<dim> supported_part(const ElasticProblem<dim>& problem,
                                  int degree);

/// The same as the mechanism holds it, if nothing else does.
/// @throws Error see surface_loads.
template <int dim>
VibratingPart<dim> held_by_mechanism(VibratingPart<dim> part,
                                     const loads::LoadHistory& history,
                                     const std::string& part_name);

/// Both. @param problem  of its loads only what the mechanism holds is asked
///   for.
template <int dim>
VibratingPart<dim> vibrating_part(const ElasticProblem<dim>& problem,
                                  int degree);

/// Load on a group of the surface: 1 N along a direction, spread evenly. Its
/// product with a displacement field is the group's mean displacement along
/// the direction.
/// @param direction  unit, in L; of dim = 2 in the plane.
/// @return equations × 1 [1].
/// @throws Error M003.
template <int dim>
Eigen::VectorXd unit_load(const VibratingPart<dim>& part,
                          const std::string& group,
                          const Eigen::Vector3d& direction,
                          const std::string& place);

}  // namespace clevis::elasticity
