#include "numerics/integrators/dop853.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace clevis::numerics {

using Eigen::VectorXd;
using namespace dop853;

namespace {

// |h λ| up to which the method is stable on the negative real axis.
constexpr double kStabilityBound = 6.1;

double norm(const VectorXd& error, const VectorXd& weights) {
  const auto n = static_cast<double>(error.size());
  return std::sqrt(error.cwiseProduct(weights).squaredNorm() / n);
}

}  // namespace

Dop853::Dop853(OdeSystem& system) : system_(system) {
  const int n = system.size();
  for (VectorXd* v :
       {&y_start_, &y_, &trial_, &stage_, &weights_, &scratch_, &slope_}) {
    v->setZero(n);
  }
  for (VectorXd& k : k_) k.setZero(n);
  for (VectorXd& d : dense_) d.setZero(n);
}

void Dop853::restart(double t, const VectorXd& y, double step) {
  t_ = t_start_ = t;
  y_ = y_start_ = y;
  system_.rate(t, y_, slope_);
  ++counts_.evaluations;
  last_error_ = 1e-4;
  stiff_steps_ = calm_steps_ = 0;
  h_ = step > 0.0 ? step : first_step();
}

/// Hairer's choice: a step over which an Euler step would err by 1 % of the
/// scale, sharpened by the second derivative.
double Dop853::first_step() {
  system_.error_weights(y_, weights_);
  const double f = norm(slope_, weights_), size = norm(y_, weights_);
  double h = f > 1e-10 && size > 1e-10 ? 0.01 * size / f : 1e-6;
  stage_ = y_ + h * slope_;
  system_.rate(t_ + h, stage_, k_[1]);
  ++counts_.evaluations;
  scratch_ = k_[1] - slope_;
  const double second = norm(scratch_, weights_) / h;
  const double steepest = std::max(f, second);
  const double by_order =
      steepest > 1e-15 ? std::pow(0.01 / steepest, 1.0 / 8.0) : 1e-3 * h;
  return std::isfinite(by_order) ? std::min(100.0 * h, by_order) : 1e-3 * h;
}

double Dop853::attempt(double h) {
  k_[0] = slope_;
  std::size_t entry = 0;
  for (int i = 1; i <= kStages; ++i) {
    VectorXd& y = i == kStages ? trial_ : stage_;
    y = y_;
    for (; entry < kA.size() && kA[entry].row == i; ++entry) {
      y += (h * kA[entry].value) *
           k_[static_cast<std::size_t>(kA[entry].column)];
    }
    system_.rate(t_ + kC[static_cast<std::size_t>(i)] * h, y,
                 k_[static_cast<std::size_t>(i)]);
  }
  counts_.evaluations += kStages;
  return error(h);
}

double Dop853::error(double h) {
  // the smaller scale of both ends: the stricter one
  system_.error_weights(y_, weights_);
  scratch_.setZero();
  for (const Entry& e : kE5) {
    scratch_ += e.value * k_[static_cast<std::size_t>(e.column)];
  }
  const double fifth = norm(scratch_, weights_);
  scratch_ = (trial_ - y_) / h;
  for (const Entry& e : kE3) {
    scratch_ -= e.value * k_[static_cast<std::size_t>(e.column)];
  }
  const double third = norm(scratch_, weights_);
  const double both = std::sqrt(fifth * fifth + 0.01 * third * third);
  const double result = both > 0.0 ? h * fifth * fifth / both : 0.0;
  return std::isfinite(result) && trial_.allFinite() && k_[kStages].allFinite()
             ? result
             : std::numeric_limits<double>::infinity();
}

void Dop853::judge_stiffness(double h) {
  scratch_ = k_[12] - k_[11];
  const double slopes = scratch_.cwiseProduct(weights_).squaredNorm();
  scratch_ = trial_ - stage_;  // stage_ is still that of slope 11
  const double states = scratch_.cwiseProduct(weights_).squaredNorm();
  if (states > 0.0 &&
      h * h * slopes > kStabilityBound * kStabilityBound * states) {
    ++stiff_steps_;
    calm_steps_ = 0;
  } else if (++calm_steps_ == 6) {
    stiff_steps_ = 0;
  }
}

bool Dop853::step(double limit) {
  const double shortest = 16.0 * std::numeric_limits<double>::epsilon() *
                          std::max(std::abs(t_), std::abs(limit));
  bool rejected = false;
  for (;;) {
    double h = std::min(h_, limit - t_);
    // no splinter at the end
    if (h < limit - t_ && 1.01 * h > limit - t_) h = limit - t_;
    const bool last = h >= limit - t_;
    const double err = attempt(h);
    if (err <= 1.0) {
      judge_stiffness(h);
      // PI control; no growth after a rejection
      double factor = 0.9 * std::pow(std::max(err, 1e-10), -0.7 / 8.0) *
                      std::pow(last_error_, 0.4 / 8.0);
      factor = std::clamp(factor, 0.333, rejected ? 1.0 : 6.0);
      last_error_ = std::max(err, 1e-4);
      h_ = last && h < h_ ? std::max(h_, h * factor) : h * factor;
      t_start_ = t_;
      y_start_.swap(y_);
      y_ = trial_;  // trial_ stays the uncorrected end, for the dense output
      slope_ = k_[kStages];
      t_ = last ? limit : t_ + h;
      dense_ready_ = false;
      ++counts_.steps;
      return true;
    }
    rejected = true;
    ++counts_.rejected;
    const double factor =
        std::isfinite(err)
            ? std::clamp(0.9 * std::pow(err, -1.0 / 8.0), 0.2, 0.9)
            : 0.1;
    h_ = h * factor;
    if (!(h_ > shortest)) return false;
  }
}

void Dop853::prepare_dense() {
  const double h = t_ - t_start_;
  std::size_t entry = 0;
  while (kA[entry].row <= kStages) ++entry;
  for (int i = kStages + 1; i < kAllStages; ++i) {
    stage_ = y_start_;
    for (; entry < kA.size() && kA[entry].row == i; ++entry) {
      stage_ += (h * kA[entry].value) *
                k_[static_cast<std::size_t>(kA[entry].column)];
    }
    system_.rate(t_start_ + kC[static_cast<std::size_t>(i)] * h, stage_,
                 k_[static_cast<std::size_t>(i)]);
  }
  counts_.evaluations += kAllStages - kStages - 1;
  for (VectorXd& d : dense_) d.setZero();
  dense_[0] = trial_ - y_start_;
  dense_[1] = h * k_[0] - dense_[0];
  dense_[2] = 2.0 * dense_[0] - h * (k_[kStages] + k_[0]);
  for (const Entry& e : kD) {
    dense_[static_cast<std::size_t>(3 + e.row)] +=
        (h * e.value) * k_[static_cast<std::size_t>(e.column)];
  }
  dense_ready_ = true;
}

void Dop853::interpolate(double t, VectorXd& y) {
  if (!dense_ready_) prepare_dense();
  const double x = (t - t_start_) / (t_ - t_start_);
  y.setZero();
  for (int i = 6; i >= 0; --i) {
    y += dense_[static_cast<std::size_t>(i)];
    y *= i % 2 == 0 ? x : 1.0 - x;
  }
  y += y_start_;
}

void Dop853::correct(const VectorXd& y) {
  system_.error_weights(y_, weights_);
  scratch_ = y - y_;
  const bool matters = norm(scratch_, weights_) > 0.01;
  y_ = y;
  if (!matters) return;
  system_.rate(t_, y_, slope_);
  ++counts_.evaluations;
}

}  // namespace clevis::numerics
