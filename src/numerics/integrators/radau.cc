#include "numerics/integrators/radau.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace clevis::numerics {

using Eigen::VectorXd;

namespace {

constexpr double kSafe = 0.9;
// |h λ| below which DOP853 would be stable at the same steps.
constexpr double kEasy = 2.0;
// Newton that contracts better needs no new Jacobian, which costs as many
// evaluations as there are states; a step of Newton costs three.
constexpr double kGoodContraction = 0.1;
// A step with which Newton failed is tried again after some shorter ones only.
constexpr double kShorter = 0.5, kLonger = 1.25;
// How fast axes that did worse become worth another trial.
constexpr double kForget = 0.9;
// Seven stages pay where steps may err by less than this part of the scale.
constexpr double kFine = 2e-9;

}  // namespace

Radau::Radau(OdeSystem& system)
    : system_(system),
      collocation_(system),
      last_method_(&collocation_.method()) {
  const int n = system.size();
  for (VectorXd* v : {&y_start_, &y_, &weights_, &slope_, &trial_slope_,
                      &scratch_, &embedded_}) {
    v->setZero(n);
  }
  for (VectorXd& d : dense_) d.setZero(n);
}

Collocation::Axes Radau::AxesChoice::choose() {
  const std::size_t other = 1 - at;
  slowness[other] *= kForget;
  if (slowness[other] < slowness[at]) at = other;
  return at == 0 ? Collocation::Axes::kFixed : Collocation::Axes::kMoving;
}

void Radau::count() {
  counts_.evaluations = collocation_.evaluations();
  counts_.factorisations = collocation_.jacobian().factorisations();
}

void Radau::restart(double t, const VectorXd& y, double step) {
  t_ = t_start_ = t;
  y_ = y_start_ = y;
  collocation_.start(t, y_, slope_);
  stale_slope_ = false;
  system_.error_weights(y_, weights_);
  system_.scales(y_, scratch_);
  const double digits = weights_.cwiseProduct(scratch_).maxCoeff();
  collocation_.use(radau_method(digits > 1.0 / kFine ? 7 : 5));
  has_past_ = false;
  refresh_ = true;
  easy_steps_ = 0;
  h_ = step;
  longest_ = std::numeric_limits<double>::infinity();
  if (h_ > 0.0) return;
  // an Euler step that would move by a hundredth of the scale
  system_.scales(y_, scratch_);
  double fastest = 0.0;
  for (Eigen::Index i = 0; i < y_.size(); ++i) {
    if (scratch_[i] > 0.0) {
      fastest = std::max(fastest, std::abs(slope_[i]) / scratch_[i]);
    }
  }
  h_ = fastest > 0.0 ? 1e-4 / fastest : 1e-4;
}

/// Of the last step, at s steps since its start: what y has changed by.
void Radau::take_polynomial(double s, VectorXd& z) const {
  const RadauMethod::Weights weights = last_method_->at(s);
  z = weights[0] * dense_[0];
  for (std::size_t j = 1; j < last_method_->count(); ++j) {
    z += weights[j] * dense_[j];
  }
}

void Radau::guess_stages(double h) {
  Collocation::Stages& z = collocation_.stages();
  const RadauMethod& method = collocation_.method();
  if (!has_past_) {
    for (std::size_t i = 0; i < method.count(); ++i) z[i].setZero();
    collocation_.guess_efforts();
    return;
  }
  // the last polynomial goes on
  RadauMethod::Weights since{};
  for (std::size_t i = 0; i < method.count(); ++i) {
    since[i] = 1.0 + method.c[i] * h / last_h_;
    take_polynomial(since[i], z[i]);
    z[i] -= dense_[last_method_->count() - 1];
  }
  collocation_.guess_efforts(since);
}

double Radau::error(double h, bool careful) {
  collocation_.embedded(h, embedded_);
  scratch_ = embedded_ + slope_;
  collocation_.filter(y_, scratch_);
  double err = weighted_norm(scratch_, weights_);
  if (err >= 1.0 && careful) {
    collocation_.slope_beyond(t_, y_, scratch_, trial_slope_);
    scratch_ = embedded_ + trial_slope_;
    collocation_.filter(y_, scratch_);
    err = weighted_norm(scratch_, weights_);
  }
  return std::max(err, 1e-10);
}

/// Error of a step h over the allowed one; infinite without convergence.
double Radau::attempt(double h, bool careful) {
  constexpr double kFailed = std::numeric_limits<double>::infinity();
  if (refresh_) {
    if (stale_slope_) collocation_.slope(t_, y_, slope_);
    stale_slope_ = false;
    collocation_.linearise(t_, y_, slope_, axes_.choose());
    refresh_ = false;
    fresh_jacobian_ = true;
  }
  if (!collocation_.jacobian().is_factored_for(h) && !collocation_.factor(h)) {
    return kFailed;
  }
  guess_stages(h);
  const bool solved = collocation_.solve(t_, y_, h, weights_);
  if (fresh_jacobian_) axes_.note(collocation_.contraction(), h);
  if (!solved) return kFailed;
  const double err = error(h, careful);
  return std::isfinite(err) ? err : kFailed;
}

void Radau::judge_stiffness(double h) {
  const bool easy = h * collocation_.jacobian().stiffness() < kEasy;
  easy_steps_ = easy ? easy_steps_ + 1 : 0;
}

void Radau::accept(double h, double err, double limit, bool rejected) {
  const double newton = collocation_.iterations();
  const double most = collocation_.most_iterations();
  const double safe =
      std::min(kSafe, kSafe * (1.0 + 2.0 * most) / (newton + 2.0 * most));
  const double power = 1.0 / collocation_.method().order_of_error();
  double quotient = std::clamp(std::pow(err, power) / safe, 0.125, 5.0);
  if (has_past_ && last_method_ == &collocation_.method()) {
    const double predicted =
        last_h_ / h * std::pow(err * err / last_error_, power) / kSafe;
    quotient = std::max(quotient, std::clamp(predicted, 0.125, 5.0));
  }
  last_error_ = std::max(1e-2, err);
  last_h_ = h;
  collocation_.accept();
  has_past_ = true;
  std::swap(dense_, collocation_.stages());
  last_method_ = &collocation_.method();
  t_start_ = t_;
  y_start_ = y_;
  y_ += dense_[last_method_->count() - 1];
  t_ = t_ + h >= limit ? limit : t_ + h;
  collocation_.slope(t_, y_, slope_);
  stale_slope_ = false;
  system_.error_weights(y_, weights_);
  if (rejected) quotient = std::max(quotient, 1.0);
  const double next = std::min(h / quotient, longest_);
  longest_ *= kLonger;
  const bool slow = collocation_.contraction() > kGoodContraction;
  refresh_ = slow;
  fresh_jacobian_ = false;
  // keep the factors where little is won
  const bool keep = !slow && next >= h && next <= 1.2 * h;
  h_ = keep ? h : next;
}

bool Radau::step(double limit) {
  const double shortest = 16.0 * std::numeric_limits<double>::epsilon() *
                          std::max(std::abs(t_), std::abs(limit));
  bool rejected = false;
  for (;;) {
    double h = std::min(h_, limit - t_);
    if (h < limit - t_ && 1.01 * h > limit - t_) h = limit - t_;
    const double wanted = h_;
    const double err = attempt(h, rejected || !has_past_);
    if (err < 1.0) {
      const bool cut = h < wanted;
      judge_stiffness(h);
      accept(h, err, limit, rejected);
      if (cut) h_ = std::max(h_, wanted);
      ++counts_.steps;
      count();
      return true;
    }
    rejected = true;
    ++counts_.rejected;
    if (std::isfinite(err)) {
      const double power = 1.0 / collocation_.method().order_of_error();
      h_ = h / std::clamp(std::pow(err, power) / kSafe, 1.1, 5.0);
      if (!has_past_) h_ = 0.1 * h;
    } else {
      h_ = kShorter * h;
      if (fresh_jacobian_) {
        longest_ = h_;
      } else {
        refresh_ = true;
        h_ = h;
      }
    }
    if (!(h_ > shortest)) {
      count();
      return false;
    }
  }
}

void Radau::interpolate(double t, VectorXd& y) {
  take_polynomial((t - t_start_) / (t_ - t_start_), y);
  y += y_start_;
}

void Radau::state_at(double t, VectorXd& y) {
  const double h = t - t_start_;
  if (t >= t_) {
    interpolate(t_, y);
    return;
  }
  interpolate(t, y);
  if (!(h > 0.0)) return;
  const RadauMethod& next = collocation_.method();
  collocation_.use(*last_method_);
  Collocation::Stages& z = collocation_.stages();
  RadauMethod::Weights since{};
  for (std::size_t i = 0; i < last_method_->count(); ++i) {
    since[i] = last_method_->c[i] * h / (t_ - t_start_);
    take_polynomial(since[i], z[i]);
  }
  collocation_.guess_efforts(since);
  const bool solved = collocation_.factor(h) &&
                      collocation_.solve(t_start_, y_start_, h, weights_);
  if (solved) y = y_start_ + z[last_method_->count() - 1];
  collocation_.use(next);
}

double Radau::largest_eigenvalue(double t, const VectorXd& y) {
  collocation_.start(t, y, trial_slope_);
  collocation_.linearise(t, y, trial_slope_, Collocation::Axes::kFixed);
  refresh_ = true;
  count();
  return collocation_.jacobian().largest_eigenvalue();
}

void Radau::correct(const VectorXd& y) {
  scratch_ = y - y_;
  const bool matters = weighted_norm(scratch_, weights_) > 0.01;
  y_ = y;
  stale_slope_ = !matters;
  if (matters) collocation_.slope(t_, y_, slope_);
}

}  // namespace clevis::numerics
