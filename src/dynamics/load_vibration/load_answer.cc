#include "dynamics/load_vibration/load_answer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dynamics/load_vibration/forced_interval.h"

namespace clevis::dynamics {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Of a mode's largest, the least change within τ that is spread.
constexpr double kSharp = 0.1;

double energy_of(const ArrayXd& omega, const SwingState& state) {
  return 0.5 * (state.rate.square() + (omega * state.w).square()).sum();
}

/// What is left to each mode of a change of the loads.
class Spread {
 public:
  Spread(const ArrayXd& omega, double front, const ArrayXd& largest)
      : square_(omega.square()), front_(front), least_(kSharp * largest) {
    constexpr double kTrue = 3.0, kUntrue = 6.0;  // ω τ
    const ArrayXd fall =
        ((front * omega - kTrue) / (kUntrue - kTrue)).max(0.0).min(1.0);
    gentle_ = 0.5 * (1.0 + (std::numbers::pi * fall).cos());
  }

  /// @param size    of the change within τ, of each mode's coordinate.
  /// @param length  that it takes: an even rise spreads by length/√12 already.
  ArrayXd left(const ArrayXd& size, double length = 0.0) const {
    return (size > least_).select(sharp(length), gentle_);
  }
  /// @param x  cubic of each mode over an interval of this length.
  void take_from(MatrixXd& x, double length) const {
    const VectorXd start = 2.0 * x.col(1),
                   end = start + 6.0 * length * x.col(2);
    const ArrayXd most = start.cwiseAbs().cwiseMax(end.cwiseAbs());
    x = left(front_ * front_ * most, length).matrix().asDiagonal() * x;
  }
  ArrayXd sharp(double length = 0.0) const {
    const double missing =
        std::max(0.0, front_ * front_ - length * length / 12.0);
    return (-0.5 * missing * square_).exp();
  }

 private:
  ArrayXd square_;
  double front_;
  ArrayXd least_, gentle_;
};

}  // namespace

LoadAnswer answer_to(const LoadPath& path, const MatrixXd& participation,
                     const VectorXd& squares, const ModeDamping& damping,
                     const VectorXd& others, double front) {
  const ArrayXd omega = squares.array().sqrt();
  const ArrayXd largest = (participation * path.values())
                              .rowwise()
                              .lpNorm<Eigen::Infinity>()
                              .array();
  const Spread spread(omega, front, largest);
  const DampedModes modes(omega, damping);
  const Index n = path.size() + others.size();
  LoadAnswer answer{VectorXd(n), MatrixXd(path.coordinates(), n),
                    MatrixXd(squares.size(), n), VectorXd(n)};
  Index row = 0;
  const auto put = [&](double t, const VectorXd& c, const SwingState& state) {
    answer.time[row] = t;
    answer.path.col(row) = c;
    answer.added.col(row) = state.w;
    answer.energy[row++] = energy_of(omega, state);
  };
  SwingState state{ArrayXd::Zero(squares.size()),
                   ArrayXd::Zero(squares.size())};
  put(path.time()[0], path.values().col(0), state);
  Index next = 0;
  for (Index i = 0; i + 1 < path.size(); ++i) {
    const double from = path.time()[i], to = path.time()[i + 1];
    const MatrixXd cubic = path.cubic(i);
    const ArrayXd bend = (participation * path.bend(i)).array();
    state.rate -= spread.left(front * bend.abs()) * bend;
    if (path.is_jump(i)) {
      const ArrayXd jump =
          (participation * (path.values().col(i + 1) - path.values().col(i)))
              .array();
      state.w -= spread.sharp() * jump;
    } else {
      MatrixXd x = participation * cubic;
      spread.take_from(x, to - from);
      const ForcedInterval<ArrayXd> alone(omega, damping.own, x, state);
      const DampedModes::Interval coupled(modes, x, state);
      const auto state_at = [&](double t) {
        SwingState there = alone.at(t);
        coupled.put(t, there);
        return there;
      };
      for (; next < others.size() && others[next] < to; ++next) {
        // Within a jump: as behind it. What is damped would grow backwards.
        const double t = std::max(0.0, others[next] - from);
        put(others[next],
            path.values().col(i) +
                t * (cubic.col(0) + t * (cubic.col(1) + t * cubic.col(2))),
            state_at(t));
      }
      state = state_at(to - from);
    }
    put(to, path.values().col(i + 1), state);
  }
  for (; next < others.size(); ++next) {
    put(others[next], path.values().col(path.size() - 1), state);
  }
  return answer;
}

double cut_by_spread(const LoadPath& path, const MatrixXd& participation,
                     const VectorXd& squares, double front) {
  // A change that is not spread takes off less.
  constexpr double kUntouched = 0.5 * kSharp;
  constexpr int kBeside = 3, kPoints = 32;
  constexpr double kWidth = 4.0;
  const MatrixXd x = participation * path.values();
  double cut = 0.0, most = 0.0;
  for (Index k = 0; k < x.rows(); ++k) {
    Index at = 0;
    const double largest = x.row(k).cwiseAbs().maxCoeff(&at);
    const double time = path.time()[at];
    const auto mean = [&](double middle) {
      double sum = 0.0, weights = 0.0;
      for (int j = -kPoints; j <= kPoints; ++j) {
        const double offset = kWidth * j / kPoints;
        const double weight = std::exp(-0.5 * offset * offset);
        sum +=
            weight * participation.row(k).dot(path.at(middle + offset * front));
        weights += weight;
      }
      return std::abs(sum / weights);
    };
    // Beside a step the spread load is as large a little later or sooner.
    double left = 0.0;
    for (int j = -kBeside; j <= kBeside; ++j) {
      left = std::max(left, mean(time + j * front));
    }
    const double omega = std::sqrt(squares[k]);
    most = std::max(most, omega * largest);
    const double taken = largest - left;
    if (taken > kUntouched * largest) cut = std::max(cut, omega * taken);
  }
  return most > 0.0 ? cut / most : 0.0;
}

}  // namespace clevis::dynamics
