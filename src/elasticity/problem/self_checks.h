#pragma once

#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "elasticity/assembly/stiffness.h"
#include "elasticity/fe_space/discretization.h"
#include "elasticity/nodal_loads/load_basis.h"

namespace clevis::elasticity {

/// Residuals checked on every solve; largest over instants or columns.
struct SolveChecks {
  double relief{};       ///< discrete residual that inertia relief takes up [1]
  double balance{};      ///< what is left of it over the load: free parts [1]
  double equilibrium{};  ///< support reactions over the load: free parts [1]
  double residual{};     ///< ‖K u − f‖ / ‖f‖ [1]
  /// Round-off of K u over the load, per column and per instant; only if
  /// `residual` or `equilibrium` is suspicious [1].
  double residual_round_off{}, equilibrium_round_off{};
  double energy{};       ///< |uᵀK u − fᵀu| / |fᵀu| [1]
  double compression{};  ///< load basis against loads [1]
};

/// A stiffness matrix, assembled or not, as what the checks need of it.
struct StiffnessAction {
  using Product = std::function<Eigen::MatrixXd(const Eigen::MatrixXd&)>;
  Product multiply;           ///< U -> K U
  Product multiply_absolute;  ///< U -> |K| U
};

/// @param stiffness  outlives the action.
template <int dim>
StiffnessAction action_of(const StiffnessMatrix<dim>& stiffness);

/// Puts the discrete loads (dofs × instants, or columns and coefficients) of a
/// free part in balance; fills `relief` and `balance`.
/// @param positions  of the nodes [m].
/// @param density [kg/m³].
template <int dim>
void balance_free_part(
    const Discretization<dim>& discretization,
    const Eigen::Matrix<double, dim, Eigen::Dynamic>& positions, double density,
    Eigen::MatrixXd& history, SolveChecks& checks);

/// @param positions  of the nodes [m].
/// @param density [kg/m³].
template <int dim>
void balance_free_part(
    const Discretization<dim>& discretization,
    const Eigen::Matrix<double, dim, Eigen::Dynamic>& positions, double density,
    SplitLoads& loads, SolveChecks& checks);

/// Takes what round-off has brought out of balance, as in combinations of many
/// columns, out of the columns of a free part's loads (dofs × columns).
/// @param modes  rigid, in the columns' unknowns.
void restore_balance(const Eigen::MatrixXd& modes, Eigen::MatrixXd& columns);

/// Sets what SolutionCheck fills back to nothing.
void forget_solution(SolveChecks& checks);

/// Checks solutions of K U = F; a part that is solved in classes gives one
/// after the other.
class SolutionCheck {
 public:
  /// @param largest_load  norm of the largest instant [N].
  SolutionCheck(Eigen::Index instants, double largest_load)
      : largest_load_(largest_load),
        energy_(Eigen::VectorXd::Zero(instants)),
        work_(Eigen::VectorXd::Zero(instants)) {}

  /// Fills `residual`, `equilibrium` and the round-off of both.
  /// @param loads   F and the coefficients of the instants.
  /// @param norms   of the columns, to which `residual` refers [N].
  /// @param held    rows that are held at zero, sorted.
  /// @param without_reaction  those of them that may not take any force.
  /// @param weight  of the energies.
  void add(const StiffnessAction& stiffness, const Eigen::MatrixXd& columns,
           const LoadBasis& loads, const Eigen::ArrayXd& norms,
           const std::vector<int>& held,
           const std::vector<int>& without_reaction, double weight,
           SolveChecks& checks);

  /// Fills `energy`.
  /// @return strain energy per instant [J].
  Eigen::VectorXd strain_energy(SolveChecks& checks) const;

 private:
  double largest_load_;
  Eigen::VectorXd energy_, work_;  ///< uᵀK u, fᵀu per instant
};

/// The same for one solution as a whole.
/// @param columns  displacements, dofs × columns [m].
/// @return strain energy per instant [J].
Eigen::VectorXd check_solution(const StiffnessAction& stiffness,
                               const Eigen::MatrixXd& columns,
                               const LoadBasis& loads,
                               const std::vector<int>& held, bool is_free,
                               SolveChecks& checks);

/// Whether a check of the solution is in the reach of round-off: refine and
/// check again.
bool wants_refinement(const SolveChecks& checks);

/// @throws Error F003 naming the first check that is breached.
void require_checks(const SolveChecks& checks, int geometry_degree,
                    const std::string& part_name);

}  // namespace clevis::elasticity
