#pragma once

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "elasticity/multigrid/p_multigrid.h"

namespace clevis::elasticity {

/// Effort of a solve, largest over the columns.
struct MultigridReport {
  int iterations{};   ///< conjugate gradients, to the tolerance
  double residual{};  ///< ‖f − K u‖ / ‖f‖ with K applied to the result
  double setup_seconds{}, solve_seconds{};
  double coarse_seconds{};  ///< of solve_seconds, in the direct solve
};

/// K U = F for many columns without K [N/m]: conjugate gradients in double
/// precision, a recurrence per column, preconditioned by PMultigrid.
/// Bit-identical for any number of threads.
class MultigridSolver {
 public:
  /// @param held  degrees of freedom of the discretisation that are zero.
  /// @pre hexahedra of one degree, 2…4, in all directions.
  /// @throws Error M005 if a cell folds, F002 from the coarsest level.
  MultigridSolver(const Discretization<3>& discretization,
                  const part::Material& material, const std::vector<int>& held,
                  const std::string& place,
                  const MultigridOptions& options = {});
  ~MultigridSolver();

  /// dofs × columns; held rows of the loads don't matter, of the result are
  /// zero. The tolerance may be missed if round-off doesn't allow it: see
  /// report().
  Eigen::MatrixXd solve(const Eigen::MatrixXd& loads);

  /// K u with all rows, those of the supports included.
  Eigen::MatrixXd multiply(const Eigen::MatrixXd& columns) const;
  /// |diagonal of K| |u|: at most |K| |u|.
  Eigen::MatrixXd multiply_absolute_diagonal(
      const Eigen::MatrixXd& columns) const;

  const MultigridReport& report() const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace clevis::elasticity
