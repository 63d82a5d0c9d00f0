#pragma once

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "dynamics/load_vibration/load_shapes.h"
#include "elasticity/problem/displacement_basis.h"
#include "elasticity/problem/elastic_problem.h"
#include "elasticity/vibration/pin_reactions.h"
#include "elasticity/vibration/vibrating_part.h"

namespace clevis::elasticity {

/// A part at rest under every instant of its load history, and its equations:
/// what its vibration is about, however its mechanism holds it.
template <int dim>
struct PartAtRest {
  DisplacementBasis<dim> statics;  ///< quasi-static answer
  VibratingPart<dim> part;         ///< as supported_part()
};

/// @param problem  its supports hold the part, or it floats: then the loads
///   are in balance with its inertia at every instant.
/// @param degree   of the displacement, 1…4 (simplices 1…2).
/// @throws Error as solve() and supported_part().
template <int dim>
PartAtRest<dim> part_at_rest(const ElasticProblem<dim>& problem, int degree);

/// The shapes in which a part can vibrate about its answer at rest under a load
/// history. A part that floats vibrates without rigid motion, its seats held
/// and weighed in the mean by the mechanism.
template <int dim>
class LoadVibration {
 public:
  /// @param history  that of `rest`, its hold_time when the mechanism holds it.
  /// @param name     of the part.
  /// @param driving  instants whose loads the vibration comes from.
  /// @param borne    those among which each pin bears most as it swings.
  /// @throws Error F008, and as held_by_mechanism().
  LoadVibration(const PartAtRest<dim>& rest, const loads::LoadHistory& history,
                const std::string& name,
                const std::vector<Eigen::Index>& driving,
                const std::vector<Eigen::Index>& borne);
  LoadVibration(const LoadVibration&) = delete;  // space_ looks at part_
  LoadVibration& operator=(const LoadVibration&) = delete;

  /// Different loads at the driving instants, to 2 % of the energy norm.
  Eigen::Index driving_loads() const { return driving_loads_; }

  struct Shapes {
    /// With what pins press beside what the hold spreads evenly, dofs × shapes
    /// [1/√kg].
    Eigen::MatrixXd columns;
    Eigen::VectorXd squares;        ///< ω² [1/s²], rising
    Eigen::MatrixXd participation;  ///< shapesᵀ M U, U of the statics
    /// Of each shape's strain energy what the part has, not springs that hold
    /// it [1].
    Eigen::VectorXd own_share;
    Eigen::MatrixXd dampers;  ///< shapesᵀ D Dᵀ shapes of those [1/s]
  };
  /// At least so many, or all that the loads excite.
  Shapes shapes(int count);

 private:
  /// Answers of the part alone as its mechanism holds it, no longer than the
  /// equations: moved, without strain, to where holds and springs rest.
  Eigen::MatrixXd settled(Eigen::MatrixXd answers) const;

  VibratingPart<dim> part_;
  PinReactions<dim> pins_;
  Eigen::MatrixXd pressed_;   ///< settled differences of pins_
  Eigen::MatrixXd weighted_;  ///< M U
  Eigen::Index driving_loads_{};
  std::unique_ptr<dynamics::LoadShapes> space_;
};

}  // namespace clevis::elasticity
