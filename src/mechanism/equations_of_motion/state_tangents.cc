#include "mechanism/equations_of_motion/state_tangents.h"

#include <algorithm>
#include <cmath>

#include "numerics/factors/jacobian_factor.h"

namespace clevis::mechanism {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

StateTangents::StateTangents(EquationsOfMotion& equations,
                             const StateScales& scales)
    : equations_(equations),
      scales_(scales),
      sizes_(VectorXd::Zero(equations.layout().size())) {}

Index StateTangents::put(double t, const VectorXd& y, MatrixXd& T) {
  const StateLayout& layout = equations_.layout();
  const ForceModel& forces = equations_.forces();
  put_open_velocities(equations_.place(t, y));
  const Index freedom = open_.cols(), positions = layout.velocity_index();
  T.leftCols(2 * freedom + forces.internal_states()).setZero();
  for (Index j = 0; j < freedom; ++j) {
    const auto open = open_.col(j);
    layout.put_displacement(y, open, T.col(j).head(positions));
    T.col(j) *= layout.length();
    T.col(freedom + j).segment(positions, layout.velocities()) =
        scales_.speed_scale() * open;
  }
  scales_.put_scales(y, forces, sizes_);
  Index used = 2 * freedom;
  for (Index i = layout.internal_index(); i < layout.work_index(); ++i) {
    if (sizes_[i] == 0.0) continue;
    T(i, used++) = std::max(sizes_[i], std::abs(y[i]));
  }
  return used;
}

/// Orthonormal columns N of unknowns with J N = 0, for joints and drives.
void StateTangents::put_open_velocities(const MechanismState& state) {
  const Index rows = equations_.system().rows();
  const Index columns = equations_.system().columns();
  if (rows == 0) {
    open_.setIdentity(columns, columns);
    return;
  }
  row_space_.setThreshold(numerics::kRankThreshold);
  row_space_.compute(equations_.constraints()
                         .with_joint_rows(state.placed)
                         .topLeftCorner(rows, columns)
                         .transpose());
  const Index freedom = columns - row_space_.rank();
  open_.setZero(columns, freedom);
  open_.bottomRows(freedom).setIdentity();
  row_space_.householderQ().applyThisOnTheLeft(open_, row_workspace_);
}

}  // namespace clevis::mechanism
