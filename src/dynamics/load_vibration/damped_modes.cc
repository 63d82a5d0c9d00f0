#include "dynamics/load_vibration/damped_modes.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace clevis::dynamics {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

DampedModes::DampedModes(const ArrayXd& omega, const ModeDamping& damping) {
  constexpr double kCounts = 1e-3;
  const MatrixXd& dampers = damping.dampers;
  if (dampers.size() == 0) return;
  const ArrayXd by_dampers = 0.5 * dampers.diagonal().array() / omega;
  for (Index k = 0; k < omega.size(); ++k) {
    if (by_dampers[k] > kCounts) coupled_.push_back(k);
  }
  if (coupled_.empty()) return;
  omega_ = omega(coupled_);
  drag_ = 2.0 * damping.own(coupled_) * omega_;
  const auto n = static_cast<Index>(coupled_.size());
  MatrixXd state = MatrixXd::Zero(2 * n, 2 * n);
  state.topRightCorner(n, n).diagonal() = omega_.matrix();
  state.bottomLeftCorner(n, n).diagonal() = -omega_.matrix();
  state.bottomRightCorner(n, n) = -dampers(coupled_, coupled_);
  state.bottomRightCorner(n, n).diagonal() -= drag_.matrix();
  const Eigen::EigenSolver<MatrixXd> solver(state);
  rates_ = solver.eigenvalues();
  vectors_ = solver.eigenvectors();
  inverse_ = vectors_.inverse();
}

DampedModes::Interval::Interval(const DampedModes& modes,
                                const Eigen::ArrayX3d& x,
                                const SwingState& start)
    : modes_(modes) {
  const auto n = static_cast<Index>(modes.coupled_.size());
  if (n == 0) return;
  const Eigen::ArrayX3d a = x(modes.coupled_, Eigen::all);
  const ArrayXd& drag = modes.drag_;
  const auto along = [&](const ArrayXd& force) -> VectorXcd {
    return modes.inverse_.rightCols(n) * force.matrix();
  };
  const auto over_rates = [&](const VectorXcd& v) -> VectorXcd {
    return v.cwiseQuotient(modes.rates_);
  };
  square_ = over_rates(-along(-3.0 * drag * a.col(2)));
  linear_ = over_rates(2.0 * square_ -
                       along(-6.0 * a.col(2) - 2.0 * drag * a.col(1)));
  constant_ = over_rates(linear_ - along(-2.0 * a.col(1) - drag * a.col(0)));
  VectorXd state(2 * n);
  state << (modes.omega_ * start.w(modes.coupled_)).matrix(),
      start.rate(modes.coupled_).matrix();
  free_ = modes.inverse_ * state - constant_;
}

void DampedModes::Interval::put(double t, SwingState& state) const {
  const auto n = static_cast<Index>(modes_.coupled_.size());
  if (n == 0) return;
  const VectorXcd decay = (modes_.rates_ * t).array().exp();
  const VectorXd found =
      (modes_.vectors_ *
       (decay.cwiseProduct(free_) + constant_ + t * (linear_ + t * square_)))
          .real();
  state.w(modes_.coupled_) = found.head(n).array() / modes_.omega_;
  state.rate(modes_.coupled_) = found.tail(n).array();
}

}  // namespace clevis::dynamics
