#pragma once

#include <memory>
#include <string>
#include <vector>

#include "elasticity/multigrid/matrix_free_operator.h"
#include "part/material.h"

namespace clevis::elasticity {

struct MultigridOptions {
  int threads = machine_threads();
  int smoothing_steps = 0;   ///< on either side of a level below; 0: by cells
  int coarse_degree = 0;     ///< of the direct solve: 1 or 2; 0: by size
  double tolerance = 1e-10;  ///< of ‖f − K u‖ / ‖f‖, each column
  int max_iterations = 500;
};

/// Degree of the coarsest level, which is factored: 2 unless that is large
/// or the displacement's own degree.
int coarse_degree(const Discretization<3>& discretization);

/// One V-cycle through the degrees p → 2 → 1 in single precision, kLanes
/// columns at once: Chebyshev smoothing of the fourth kind with 3 × 3 block
/// Jacobi, sparse Cholesky on the coarsest level. Symmetric, so that it
/// preconditions conjugate gradients.
/// Source: [Lottes2023].
class PMultigrid {
 public:
  /// @param held  degrees of freedom of `fine` that are zero.
  /// @pre 2 <= degree of the discretisation, coarse_degree below it.
  PMultigrid(const Discretization<3>& discretization,
             const part::Material& material, const CellSchedule& schedule,
             const NodeTable& fine, const std::vector<int>& held,
             const MultigridOptions& options, ThreadTeam& team,
             const std::string& place);
  ~PMultigrid();

  /// solution = B residual; the residual is overwritten.
  void apply(LaneVector<float>& residual, LaneVector<float>& solution);

  /// Largest eigenvalue of the Jacobi-preconditioned matrix per level above
  /// the coarsest, as estimated.
  std::vector<double> largest_eigenvalues() const;
  /// Time spent on the coarsest level so far [s].
  double coarse_seconds() const;

 private:
  struct Level;
  struct Coarsest;
  void cycle(std::size_t level, LaneVector<float>& residual,
             LaneVector<float>& solution);
  void smooth(Level& level, LaneVector<float>& residual,
              LaneVector<float>& solution, bool fresh);
  void subtract(Level& level, LaneVector<float>& residual);
  void restrict_to(Level& level, const LaneVector<float>& residual,
                   const NodeTable& coarse, LaneVector<float>& target);
  void prolong(Level& level, const LaneVector<float>& source,
               const NodeTable& coarse);
  double largest_eigenvalue(Level& level);

  const CellSchedule& schedule_;
  ThreadTeam& team_;
  int smoothing_steps_;
  std::vector<std::unique_ptr<Level>> levels_;
  std::unique_ptr<Coarsest> coarsest_;
};

}  // namespace clevis::elasticity
