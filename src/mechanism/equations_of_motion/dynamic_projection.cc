// States of ForwardDynamics onto the constraints, as drives move these.
#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "mechanism/drives/drive_law.h"
#include "mechanism/equations_of_motion/forward_dynamics.h"

namespace clevis::mechanism {

using Eigen::Index;
using Eigen::VectorXd;

DriveTarget ForwardDynamics::target(std::size_t k, double t) const {
  const BendSide side =
      t > piece_start_ ? BendSide::kBefore : BendSide::kBehind;
  return drive_target(drives_[k], t, side);
}

void ForwardDynamics::set_targets(double t) {
  for (std::size_t k = 0; k < drives_.size(); ++k) {
    const DriveTarget target = this->target(k, t);
    const Index row = system_.joint_rows() + static_cast<Index>(k);
    const double scale =
        system_.scale(system_.row_list()[static_cast<std::size_t>(row)]);
    targets_[static_cast<Index>(k)] = target.position;
    target_rates_[row] = scale * target.rate;
    target_seconds_[row] = scale * target.acceleration;
  }
}

void ForwardDynamics::jump(double t, VectorXd& y) {
  const double before = kinetic_energy(y);
  for (std::size_t k = 0; k < forces_.size(); ++k) {
    if (forces_.is_dry(k)) forces_.set_mode(k, kLetGo);
  }
  project(t, y);
  y[work_index()] += kinetic_energy(y) - before;
}

void ForwardDynamics::move(VectorXd& y, const VectorXd& change) const {
  if (planar_) {
    y.head(positions_) += change.head(positions_);
    return;
  }
  for (Index i = 0; i < positions_ / 7; ++i) {
    BodyPlacement body;
    body.p = y.segment<3>(7 * i);
    body.q.coeffs() = y.segment<4>(7 * i + 3);
    body.move(change.segment<3>(6 * i), change.segment<3>(6 * i + 3) / length_);
    y.segment<3>(7 * i) = body.p;
    y.segment<4>(7 * i + 3) = body.q.coeffs();
  }
}

double ForwardDynamics::correct_positions(double t, VectorXd& y) {
  constexpr int kMost = 4;
  constexpr double kClosed = 1e-13;
  double last = 0.0;
  for (int i = 0;; ++i) {
    system_.residual(placed_, targets_, residual_);
    residual_.tail(residual_.size() - system_.rows()).setZero();
    const double gap =
        residual_.size() == 0 ? 0.0 : residual_.lpNorm<Eigen::Infinity>();
    if (gap <= kClosed * length_ || i == kMost || (i > 1 && gap > 0.5 * last)) {
      return gap;
    }
    last = gap;
    mass_.correct(residual_, change_);
    move(y, change_);
    place(t, y);
    // the factor at hand serves unless the gap was large
    if (gap > 1e-6 * length_) factor();
  }
}

double ForwardDynamics::gap(double t, const VectorXd& y) {
  place(t, y);
  set_targets(t);
  if (system_.rows() == 0) return 0.0;
  system_.residual(placed_, targets_, residual_);
  return residual_.head(system_.rows()).lpNorm<Eigen::Infinity>();
}

double ForwardDynamics::project(double t, VectorXd& y) {
  place(t, y);
  set_targets(t);
  add_loads(t, y);
  factor();
  const double gap = correct_positions(t, y);
  system_.fill_jacobian(placed_, J_);  // sticking rows hardly turn
  residual_.head(rows_).noalias() = J_.topRows(rows_) * u_;
  residual_.head(system_.rows()) -= target_rates_.head(system_.rows());
  Index row = system_.rows();
  for (std::size_t k = 0; k < forces_.size(); ++k) {
    if (!forces_.brings_row(k)) continue;
    if (rotors_[k] >= 0) residual_[row] = 0.0;  // turns as its joint does
    ++row;
  }
  mass_.correct(residual_, change_);
  u_ += change_;
  y.segment(positions_, system_.columns()) = u_.head(system_.columns());
  place(t, y);
  return gap;
}

}  // namespace clevis::mechanism
