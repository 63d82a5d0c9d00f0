#pragma once

#include <array>
#include <optional>

#include "elasticity/multigrid/p_multigrid.h"

namespace clevis::elasticity {

/// Columns of one preconditioner application: those of two registers of
/// doubles.
inline constexpr int kBlockColumns = lanes::kLanes<float>;

/// Conjugate gradients for up to kBlockColumns independent columns, each with
/// its own recurrence; converged ones stand still. Loads are scaled
/// to norm 1, so that solutions are per newton [m/N].
///
/// The direction is corrected by the Polak–Ribière formula, which bears the
/// rounding of the single-precision preconditioner ([GolubYe1999]).
class BlockCg {
 public:
  using Lanes = Eigen::Array<double, kBlockColumns, 1>;

  BlockCg(const MatrixFreeOperator<double>& stiffness,
          PMultigrid& preconditioner, const NodeTable& nodes, ThreadTeam& team);

  /// Solves for the columns in `loads`, scaled to norm 1 (or zero), held rows
  /// zero; x starts at zero.
  /// @return iterations.
  int solve(const std::array<LaneVector<double>, 2>& loads, int blocks,
            double tolerance, int max_iterations);

  LaneVector<double>& x(int block) { return x_[std::size_t(block)]; }
  /// ‖f − K x‖ per column with K applied to the result.
  const Lanes& residual() const { return residual_; }

 private:
  using Vectors = std::array<LaneVector<double>, 2>;
  enum class Step { kProduct, kAdvance, kProducts, kDirection };
  void run(Step step, int block, const Lanes& factor, Lanes& first,
           Lanes& second);
  int iterate(int blocks, double tolerance, int max_iterations);

  const MatrixFreeOperator<double>& stiffness_;
  PMultigrid& preconditioner_;
  const NodeTable& nodes_;
  ThreadTeam& team_;
  Vectors x_, r_, p_, kp_;
  LaneVector<float> rounded_, z_;
  Lanes residual_;
};

}  // namespace clevis::elasticity
