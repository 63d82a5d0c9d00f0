#include "dynamics/systems/attached_system.h"

#include <utility>

namespace clevis::dynamics {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// One operator on the system's rows, a factor on those behind them.
BlockOperator beside(BlockOperator own, Index size, double factor) {
  return [own = std::move(own), size, factor](const MatrixXd& x) -> MatrixXd {
    MatrixXd both(x.rows(), x.cols());
    both.topRows(size) = own(x.topRows(size));
    both.bottomRows(x.rows() - size) = factor * x.bottomRows(x.rows() - size);
    return both;
  };
}

}  // namespace

LinearSystem attached_system(const LinearSystem& system, Index masses) {
  const Index size = system.size;
  LinearSystem both = system;
  both.size = size + masses;
  both.stiffness = beside(system.stiffness, size, 0.0);
  both.mass = beside(system.mass, size, 1.0);
  both.factor = [factor = system.factor, size](double shift) {
    return beside(factor(shift), size, 1.0 / shift);
  };
  both.rigid = MatrixXd::Zero(both.size, system.rigid.cols() + masses);
  both.rigid.topLeftCorner(size, system.rigid.cols()) = system.rigid;
  both.rigid.bottomRightCorner(masses, masses).setIdentity();
  return both;
}

}  // namespace clevis::dynamics
