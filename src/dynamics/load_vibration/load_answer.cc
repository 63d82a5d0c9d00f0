#include "dynamics/load_vibration/load_answer.h"

#include <cmath>

namespace clevis::dynamics {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct State {
  ArrayXd w, rate;
};

/// Free vibration of all modes about a particular solution b0 + b1 τ + b2 τ²
/// on one interval.
class Interval {
 public:
  /// @param x  a1, a2, a3 of the modes' quasi-static coordinates.
  Interval(const ArrayXd& omega, double damping, const MatrixXd& x,
           const State& start)
      : omega_(omega), damping_(damping) {
    const auto a1 = x.col(0).array(), a2 = x.col(1).array(),
               a3 = x.col(2).array();
    const ArrayXd drag = 2.0 * damping * omega;
    const ArrayXd square = omega.square();
    b2_ = -3.0 * drag * a3 / square;
    b1_ = (-6.0 * a3 - 2.0 * drag * a2 - 2.0 * drag * b2_) / square;
    b0_ = (-2.0 * a2 - drag * a1 - drag * b1_ - 2.0 * b2_) / square;
    free_ = {start.w - b0_, start.rate - b1_};
  }

  State at(double t) const {
    const ArrayXd decay = (-damping_ * omega_ * t).exp();
    const ArrayXd swing = std::sqrt(1.0 - damping_ * damping_) * omega_;
    const ArrayXd c = (swing * t).cos(), s = (swing * t).sin() / swing;
    return {
        decay * (free_.w * c + (free_.rate + damping_ * omega_ * free_.w) * s) +
            b0_ + t * (b1_ + t * b2_),
        decay * (free_.rate * c -
                 (damping_ * omega_ * free_.rate + omega_.square() * free_.w) *
                     s) +
            b1_ + 2.0 * t * b2_};
  }

 private:
  const ArrayXd& omega_;
  double damping_;
  ArrayXd b0_, b1_, b2_;
  State free_;
};

double energy_of(const ArrayXd& omega, const State& state) {
  return 0.5 * (state.rate.square() + (omega * state.w).square()).sum();
}

}  // namespace

LoadAnswer answer_to(const LoadPath& path, const MatrixXd& participation,
                     const VectorXd& squares, double damping,
                     const VectorXd& others, double front) {
  const ArrayXd omega = squares.array().sqrt();
  const ArrayXd share = (-0.5 * (front * omega).square()).exp();
  const Index n = path.size() + others.size();
  LoadAnswer answer{VectorXd(n), MatrixXd(path.coordinates(), n),
                    MatrixXd(squares.size(), n), VectorXd(n)};
  Index row = 0;
  const auto put = [&](double t, const VectorXd& c, const State& state) {
    answer.time[row] = t;
    answer.path.col(row) = c;
    answer.added.col(row) = state.w;
    answer.energy[row++] = energy_of(omega, state);
  };
  State state{ArrayXd::Zero(squares.size()), ArrayXd::Zero(squares.size())};
  put(path.time()[0], path.values().col(0), state);
  Index next = 0;
  for (Index i = 0; i + 1 < path.size(); ++i) {
    const double from = path.time()[i], to = path.time()[i + 1];
    const MatrixXd cubic = path.cubic(i);
    if (path.is_jump(i)) {
      state.w -= share * (participation *
                          (path.values().col(i + 1) - path.values().col(i)))
                             .array();
      // the rates of x on both sides may differ too
      VectorXd step = VectorXd::Zero(path.coordinates());
      if (i > 0) step -= path.end_slope(i - 1);
      if (i + 2 < path.size()) step += path.cubic(i + 1).col(0);
      state.rate -= share * (participation * step).array();
    } else {
      const Interval interval(omega, damping, participation * cubic, state);
      for (; next < others.size() && others[next] < to; ++next) {
        const double t = others[next] - from;
        put(others[next],
            path.values().col(i) +
                t * (cubic.col(0) + t * (cubic.col(1) + t * cubic.col(2))),
            interval.at(t));
      }
      state = interval.at(to - from);
    }
    put(to, path.values().col(i + 1), state);
  }
  for (; next < others.size(); ++next) {
    put(others[next], path.values().col(path.size() - 1), state);
  }
  return answer;
}

}  // namespace clevis::dynamics
