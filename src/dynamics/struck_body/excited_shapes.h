#pragma once

#include <memory>

#include <Eigen/Core>

#include "dynamics/systems/block_krylov.h"
#include "dynamics/systems/linear_system.h"

namespace clevis::dynamics {

/// K and M on a space, in the space's own modes, rigid ones first.
struct ReducedModel {
  Eigen::VectorXd squares;   ///< ω² [1/s²]
  Eigen::VectorXd contact;   ///< of each mode with c
  Eigen::MatrixXd in_space;  ///< elastic modes in the space's vectors
  /// The space has all that the load can excite.
  bool is_complete = false;
};

/// The rigid motions and the space that (K + s M)⁻¹ M makes of the static
/// answer to a load c: that answer itself (s = 0: exactly; free bodies:
/// nearly) and the modes that c excites, the lower the better, without those
/// that it does not. In such a space the answer to c converges in far fewer
/// vectors than in eigenmodes.
///
/// Source: [WilsonYuanDickens1982].
class ExcitedShapes {
 public:
  /// @param load  c, per unit of force [1].
  ExcitedShapes(const LinearSystem& system, const Eigen::VectorXd& load);

  /// cᵀ (K + s M)⁻¹ c, s = 0 for held bodies [m/N].
  double compliance() const { return compliance_; }
  int solves() const { return solves_; }

  /// By the first `vectors` of the space, or all that there are, less those
  /// modes that round-off brought in and the load does not excite.
  ReducedModel model(int vectors);

  /// Its modes, M-orthonormal; size × modes.
  Eigen::MatrixXd shapes(const ReducedModel& model) const;

 private:
  /// K on the vectors that the space has got since the last time.
  void project();

  const LinearSystem& system_;
  Eigen::VectorXd load_;
  Eigen::MatrixXd rigid_;
  std::unique_ptr<BlockKrylov> space_;
  Eigen::MatrixXd stiffness_;  ///< K on the space
  double compliance_{};
  int solves_ = 1;
};

}  // namespace clevis::dynamics
