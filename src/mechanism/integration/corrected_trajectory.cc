#include "mechanism/integration/corrected_trajectory.h"

#include <algorithm>

namespace clevis::mechanism {

using Eigen::VectorXd;

void CorrectedTrajectory::follow(numerics::Integrator& integrator, double until,
                                 const VectorXd& end) {
  integrator_ = &integrator;
  from_ = integrator.t_start();
  until_ = until;
  start_.swap(end_);
  end_ = end;
  is_chosen_ = false;
  // the uncorrected end, without the cost of dense output where it can be
  if (until == integrator.t()) correction_ = end - integrator.y();
}

const VectorXd& CorrectedTrajectory::state_at(double t) {
  if (t == until_) return end_;
  if (!is_chosen_) choose();
  is_dense_ ? put_dense(t) : put_cubic(t);
  return state_;
}

void CorrectedTrajectory::put_dense(double t) {
  integrator_->interpolate(t, state_);
  state_ += (t - from_) / (until_ - from_) * correction_;
}

void CorrectedTrajectory::put_cubic(double t) {
  const double h = until_ - from_, s = (t - from_) / h;
  const double left = (1.0 - s) * (1.0 - s), right = s * s;
  state_ = left * ((1.0 + 2.0 * s) * start_ + s * h * start_rate_) +
           right * ((3.0 - 2.0 * s) * end_ + (s - 1.0) * h * end_rate_);
}

/// By the largest gap at some times between.
void CorrectedTrajectory::choose() {
  constexpr double kLooks[] = {0.25, 0.5, 0.75};
  is_chosen_ = true;
  if (until_ != integrator_->t()) {
    integrator_->interpolate(until_, state_);
    correction_ = end_ - state_;
  }
  start_rate_.setZero(start_.size());
  end_rate_.setZero(end_.size());
  const StateLayout& layout = equations_.layout();
  layout.put_position_rates(start_, equations_.place(from_, start_),
                            start_rate_);
  layout.put_position_rates(end_, equations_.place(until_, end_), end_rate_);
  double of_dense = 0.0, of_cubic = 0.0;
  for (const double part : kLooks) {
    const double t = from_ + part * (until_ - from_);
    put_dense(t);
    of_dense = std::max(of_dense, projection_.gap(t, state_));
    put_cubic(t);
    of_cubic = std::max(of_cubic, projection_.gap(t, state_));
  }
  is_dense_ = of_dense <= of_cubic;
}

}  // namespace clevis::mechanism
