#pragma once

#include <memory>

#include <Eigen/Core>

#include "dynamics/systems/block_krylov.h"
#include "dynamics/systems/linear_system.h"

namespace clevis::dynamics {

/// Elastic shapes that some loads excite: Ritz vectors of the space that
/// (K + s M)⁻¹ M makes of the loads' static answers, without rigid motions.
/// Those answers are in the space exactly, the lower modes first of all.
///
/// Source: [WilsonYuanDickens1982].
class LoadShapes {
 public:
  /// @param answers  static displacements [m], equations × loads.
  LoadShapes(const LinearSystem& system, const Eigen::MatrixXd& answers);

  struct Shapes {
    Eigen::MatrixXd columns;  ///< M-orthonormal, equations × shapes
    Eigen::VectorXd squares;  ///< ω² [1/s²], rising
  };
  /// At least so many, or all that there are.
  Shapes shapes(int count);

 private:
  const LinearSystem& system_;
  std::unique_ptr<BlockKrylov> space_;
};

}  // namespace clevis::dynamics
