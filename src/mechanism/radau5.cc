#include "mechanism/radau5.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace clevis::mechanism {

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

}  // namespace

Radau5::Radau5(OdeSystem& system) : system_(system), collocation_(system) {
  const int n = system.size();
  for (VectorXd* v : {&y_start_, &y_, &weights_, &slope_, &trial_slope_,
                      &scratch_, &embedded_}) {
    v->setZero(n);
  }
  for (VectorXd& d : dense_) d.setZero(n);
}

Collocation::Axes Radau5::AxesChoice::choose() {
  const std::size_t other = 1 - at;
  slowness[other] *= kForget;
  if (slowness[other] < slowness[at]) at = other;
  return at == 0 ? Collocation::Axes::kFixed : Collocation::Axes::kMoving;
}

void Radau5::count() {
  counts_.evaluations = collocation_.evaluations();
  counts_.factorisations = collocation_.factorisations();
}

void Radau5::restart(double t, const VectorXd& y, double step) {
  t_ = t_start_ = t;
  y_ = y_start_ = y;
  collocation_.start(t, y_, slope_);
  stale_slope_ = false;
  system_.error_weights(y_, weights_);
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

void Radau5::guess_stages(double h) {
  Collocation::Stages& z = collocation_.stages();
  if (!has_past_) {
    for (VectorXd& stage : z) stage.setZero();
    collocation_.guess_efforts();
    return;
  }
  // the last polynomial goes on
  const double c[3] = {Collocation::kC1, Collocation::kC2, 1.0};
  std::array<double, 3> since{};
  for (std::size_t i = 0; i < 3; ++i) since[i] = 1.0 + c[i] * h / last_h_;
  collocation_.guess_efforts(since);
  for (std::size_t i = 0; i < 3; ++i) {
    const double s = c[i] * h / last_h_;
    z[i] = s * (dense_[1] +
                (s - (Collocation::kC2 - 1.0)) *
                    (dense_[2] + (s - (Collocation::kC1 - 1.0)) * dense_[3]));
  }
}

double Radau5::error(double h, bool careful) {
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
double Radau5::attempt(double h, bool careful) {
  constexpr double kFailed = std::numeric_limits<double>::infinity();
  if (refresh_) {
    if (stale_slope_) collocation_.slope(t_, y_, slope_);
    stale_slope_ = false;
    collocation_.linearise(t_, y_, slope_, axes_.choose());
    refresh_ = false;
    fresh_jacobian_ = true;
  }
  if (!collocation_.is_factored_for(h) && !collocation_.factor(h)) {
    return kFailed;
  }
  guess_stages(h);
  const bool solved = collocation_.solve(t_, y_, h, weights_);
  if (fresh_jacobian_) axes_.note(collocation_.contraction(), h);
  if (!solved) return kFailed;
  const double err = error(h, careful);
  return std::isfinite(err) ? err : kFailed;
}

void Radau5::judge_stiffness(double h) {
  const bool easy = h * collocation_.stiffness() < kEasy;
  easy_steps_ = easy ? easy_steps_ + 1 : 0;
}

void Radau5::accept(double h, double err, double limit, bool rejected) {
  const Collocation::Stages& z = collocation_.stages();
  const double c1 = Collocation::kC1, c2 = Collocation::kC2;
  const double newton = collocation_.iterations();
  constexpr double kMost = Collocation::kMostIterations;
  const double safe =
      std::min(kSafe, kSafe * (1.0 + 2.0 * kMost) / (newton + 2.0 * kMost));
  double quotient = std::clamp(std::pow(err, 0.25) / safe, 0.125, 5.0);
  if (has_past_) {
    const double predicted =
        last_h_ / h * std::pow(err * err / last_error_, 0.25) / kSafe;
    quotient = std::max(quotient, std::clamp(predicted, 0.125, 5.0));
  }
  last_error_ = std::max(1e-2, err);
  last_h_ = h;
  collocation_.accept();
  has_past_ = true;
  dense_[1] = (z[1] - z[2]) / (c2 - 1.0);
  scratch_ = (z[0] - z[1]) / (c1 - c2);
  dense_[2] = (scratch_ - dense_[1]) / (c1 - 1.0);
  dense_[3] = dense_[2] - (scratch_ - z[0] / c1) / c2;
  t_start_ = t_;
  y_start_ = y_;
  y_ += z[2];
  dense_[0] = y_;
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

bool Radau5::step(double limit) {
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
      h_ = h / std::clamp(std::pow(err, 0.25) / kSafe, 1.1, 5.0);
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

void Radau5::interpolate(double t, VectorXd& y) {
  const double s = (t - t_) / (t_ - t_start_);
  y = dense_[0] +
      s * (dense_[1] +
           (s - (Collocation::kC2 - 1.0)) *
               (dense_[2] + (s - (Collocation::kC1 - 1.0)) * dense_[3]));
}

void Radau5::state_at(double t, VectorXd& y) {
  const double h = t - t_start_;
  if (t >= t_) {
    y = dense_[0];
    return;
  }
  interpolate(t, y);
  if (!(h > 0.0)) return;
  Collocation::Stages& z = collocation_.stages();
  const double c[3] = {Collocation::kC1, Collocation::kC2, 1.0};
  std::array<double, 3> since{};
  for (std::size_t i = 0; i < 3; ++i) since[i] = c[i] * h / (t_ - t_start_);
  collocation_.guess_efforts(since);
  for (std::size_t i = 0; i < 3; ++i) {
    interpolate(t_start_ + c[i] * h, z[i]);
    z[i] -= y_start_;
  }
  const bool solved = collocation_.factor(h) &&
                      collocation_.solve(t_start_, y_start_, h, weights_);
  if (solved) y = y_start_ + z[2];
}

double Radau5::largest_eigenvalue(double t, const VectorXd& y) {
  collocation_.start(t, y, trial_slope_);
  collocation_.linearise(t, y, trial_slope_, Collocation::Axes::kFixed);
  refresh_ = true;
  count();
  return collocation_.largest_eigenvalue();
}

void Radau5::correct(const VectorXd& y) {
  scratch_ = y - y_;
  const bool matters = weighted_norm(scratch_, weights_) > 0.01;
  y_ = y;
  stale_slope_ = !matters;
  if (matters) collocation_.slope(t_, y_, slope_);
}

}  // namespace clevis::mechanism
