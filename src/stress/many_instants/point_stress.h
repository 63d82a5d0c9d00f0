#pragma once

#include <vector>

#include <Eigen/Core>

#include "elasticity/problem/displacement_basis.h"
#include "part/material.h"
#include "stress/field/stress_history.h"

namespace clevis::stress {

/// Stress at some lattice points for any combinations of displacement vectors:
/// for thousands of instants of few points.
template <int dim>
class PointStress {
 public:
  /// @param points  of the lattice of `subdivisions`, those of a cell together.
  /// @param columns  displacement vectors, dofs × columns [m].
  PointStress(const elasticity::Discretization<dim>& discretization,
              const part::Material& material, int subdivisions,
              const std::vector<FieldPoint>& points,
              const Eigen::MatrixXd& columns);

  /// Von Mises [Pa], points × instants.
  /// @param coefficients  columns × instants.
  Eigen::MatrixXd von_mises(const Eigen::MatrixXd& coefficients) const;

 private:
  Eigen::Index points_;
  Eigen::MatrixXd deviator_;  ///< of stress, × columns [Pa]
};

}  // namespace clevis::stress
