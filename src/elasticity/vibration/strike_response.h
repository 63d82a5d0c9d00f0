#pragma once

#include <memory>
#include <string>

#include <Eigen/Core>

#include "dynamics/strike/strike.h"
#include "elasticity/problem/displacement_basis.h"
#include "elasticity/problem/elastic_problem.h"
#include "loads/history/strike.h"

namespace clevis::elasticity {

/// Response of a part to a strike.
template <int dim>
struct StrikeResponse {
  /// Displacements at the samples of `motion`, for stress::stress_history; the
  /// inertia of the part is in them.
  DisplacementBasis<dim> basis;
  /// Force, impulse and energies of contact, part and striker; its states are
  /// left out, and its columns stand in `basis`.
  dynamics::StrikeSolution solution;
  /// Static stiffness of the part at the struck group [N/m].
  double stiffness{};
  double mass{};  ///< of the part [kg]
  /// Wall-clock seconds of matrices and of all after them.
  double assemble_seconds{}, solve_seconds{};

  const dynamics::StrikeRun& motion() const { return solution.run; }
};

/// A part and the face that is struck, for any number of strikes: matrices are
/// made once, and shapes of strikes before are there for the next.
template <int dim>
class StruckFace {
 public:
  /// @param problem    its loads are not asked for, its mesh is copied.
  /// @param group      physical group that is struck.
  /// @param direction  of the strikers, unit, in L.
  /// @param degree     of the displacement, 1…4 (simplices 1…2).
  /// @throws Error F001, F002, F004, M003, M005.
  StruckFace(const ElasticProblem<dim>& problem, const std::string& group,
             const Eigen::Vector3d& direction, int degree);
  ~StruckFace();
  StruckFace(const StruckFace&) = delete;
  StruckFace& operator=(const StruckFace&) = delete;

  /// @param strike  on this face, along this direction.
  /// @throws Error F002, F006.
  StrikeResponse<dim> solve(const loads::Strike& strike,
                            const dynamics::StrikeOptions& options);

 private:
  struct Model;
  std::unique_ptr<Model> model_;
};

/// @param problem  its loads are not asked for: the strike is the only load,
///   the part at rest and without stress before it.
/// @param degree   of the displacement, 1…4 (simplices 1…2).
/// @throws Error F001, F002, F004, F006, M003, M005.
template <int dim>
StrikeResponse<dim> solve_strike(const ElasticProblem<dim>& problem,
                                 const loads::Strike& strike, int degree,
                                 const dynamics::StrikeOptions& options = {});

}  // namespace clevis::elasticity
