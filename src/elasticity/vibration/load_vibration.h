#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "dynamics/load_vibration/load_shapes.h"
#include "elasticity/problem/displacement_basis.h"
#include "elasticity/problem/elastic_problem.h"
#include "elasticity/vibration/vibrating_part.h"

namespace clevis::elasticity {

/// A part under its load history: the quasi-static answer to every instant, and
/// the shapes in which it can vibrate about that.
template <int dim>
class LoadVibration {
 public:
  /// @param problem  its supports hold the part, or it floats: then the loads
  ///   are in balance with its inertia at every instant, and it vibrates
  ///   without rigid motion, its seats held and weighed in the mean by the
  ///   mechanism.
  /// @param degree   of the displacement, 1…4 (simplices 1…2).
  /// @param driving  instants whose loads the vibration comes from.
  /// @throws Error as solve() and vibrating_part().
  LoadVibration(const ElasticProblem<dim>& problem, int degree,
                const std::vector<Eigen::Index>& driving);
  LoadVibration(const LoadVibration&) = delete;  // space_ looks at part_
  LoadVibration& operator=(const LoadVibration&) = delete;

  const DisplacementBasis<dim>& statics() const { return statics_; }
  /// Different loads at the driving instants, to 2 % of the energy norm.
  Eigen::Index driving_loads() const { return driving_loads_; }

  struct Shapes {
    Eigen::MatrixXd columns;        ///< dofs × shapes [1/√kg]
    Eigen::VectorXd squares;        ///< ω² [1/s²], rising
    Eigen::MatrixXd participation;  ///< shapesᵀ M U, U of statics()
  };
  /// At least so many, or all that the loads excite.
  Shapes shapes(int count);

 private:
  DisplacementBasis<dim> statics_;
  VibratingPart<dim> part_;
  Eigen::MatrixXd weighted_;  ///< M U
  Eigen::Index driving_loads_{};
  std::unique_ptr<dynamics::LoadShapes> space_;
};

}  // namespace clevis::elasticity
