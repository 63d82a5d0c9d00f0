#include "loads/history/turning_loads.h"

#include <Eigen/QR>

namespace clevis::loads {

Eigen::VectorXd share_that_turns_with(const Eigen::VectorXd& angles,
                                      const Eigen::MatrixXd& loads) {
  Eigen::MatrixX3d terms(angles.size(), 3);
  terms << Eigen::VectorXd::Ones(angles.size()), angles.array().cos().matrix(),
      angles.array().sin().matrix();
  return terms.colPivHouseholderQr().solve(loads).row(0).transpose();
}

}  // namespace clevis::loads
