#include "dynamics/load_vibration/moving_constraints.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>

namespace clevis::dynamics {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Coordinates and forces of the constraints of diag(s) q + Gᵀ λ = b, G q = 0.
VectorXd solved(const VectorXd& diagonal, const MatrixXd& rows,
                const VectorXd& right) {
  const VectorXd free = right.cwiseQuotient(diagonal);
  if (rows.rows() == 0) return free;
  const MatrixXd spread = rows * diagonal.cwiseInverse().asDiagonal();  // G s⁻¹
  const VectorXd forces = (spread * rows.transpose()).ldlt().solve(rows * free);
  return free - spread.transpose() * forces;
}

/// Parameters of the scheme, by its spectral radius at high frequencies.
struct Scheme {
  static constexpr double kRadius = 0.9;
  static constexpr double kMass = (2.0 * kRadius - 1.0) / (kRadius + 1.0);
  static constexpr double kForce = kRadius / (kRadius + 1.0);
  static constexpr double kGamma = 0.5 + kForce - kMass;
  static constexpr double kBeta = 0.25 * (kGamma + 0.5) * (kGamma + 0.5);
};

/// Values of a path at times that rise.
class Walk {
 public:
  explicit Walk(const SmoothPath& path) : path_(path) {}

  MatrixXd at(double t) {
    const Index i = path_.interval(t);
    if (i != interval_) piece_ = path_.piece(interval_ = i);
    const VectorXd& time = path_.time();
    return piece_.at((t - time[i]) / (time[i + 1] - time[i]));
  }

 private:
  const SmoothPath& path_;
  Index interval_ = -1;
  SmoothPath::Piece piece_;
};

/// Means of a path over times, beyond its ends those of the ends.
class Means {
 public:
  explicit Means(const SmoothPath& path)
      : path_(path), sums_{MatrixXd::Zero(path.value(0).rows(), 1)} {
    for (Index i = 0; i + 1 < path.time().size(); ++i) {
      sums_.emplace_back(sums_.back() + length(i) * path.piece(i).mean(1.0));
    }
  }

  VectorXd over(double from, double to) const {
    return (up_to(to) - up_to(from)) / (to - from);
  }

 private:
  double length(Index i) const { return path_.time()[i + 1] - path_.time()[i]; }
  MatrixXd up_to(double t) const {
    const VectorXd& time = path_.time();
    const Index last = time.size() - 1;
    if (t <= time[0]) return (t - time[0]) * path_.value(0);
    if (t >= time[last]) {
      return sums_.back() + (t - time[last]) * path_.value(last);
    }
    const Index i = path_.interval(t);
    return sums_[static_cast<std::size_t>(i)] +
           (t - time[i]) * path_.piece(i).mean((t - time[i]) / length(i));
  }

  const SmoothPath& path_;
  std::vector<MatrixXd> sums_;  ///< integrals up to each instant
};

/// Even steps over a path.
struct Steps {
  Steps(const VectorXd& time, double step)
      : from(time[0]),
        count(std::max<Index>(1, static_cast<Index>(std::ceil(
                                     (time[time.size() - 1] - from) / step)))),
        length((time[time.size() - 1] - from) / static_cast<double>(count)) {}
  double end(Index k) const { return from + static_cast<double>(k) * length; }

  double from;
  Index count;
  double length;
};

/// Coordinates, speeds, accelerations and those of the scheme.
struct State {
  VectorXd q, v, a, scheme;
};

void take_step(const DiagonalSystem& system, const MatrixXd& rows,
               const VectorXd& forces, double h, State& state) {
  using S = Scheme;
  const double square = S::kBeta * h * h;
  const double of_mass = (1.0 - S::kMass) / ((1.0 - S::kForce) * square);
  const double of_damping = S::kGamma / (S::kBeta * h);
  const VectorXd known =
      (state.q + h * state.v + h * h * (0.5 - S::kBeta) * state.scheme) /
      square;
  const VectorXd acceleration =
      ((S::kMass - 1.0) * known + S::kMass * state.scheme -
       S::kForce * state.a) /
      (1.0 - S::kForce);
  const VectorXd speed =
      state.v + h * (1.0 - S::kGamma) * state.scheme - h * S::kGamma * known;
  const VectorXd diagonal =
      of_mass * system.mass + of_damping * system.damping + system.stiffness;
  state.q = solved(diagonal, rows,
                   forces - system.mass.cwiseProduct(acceleration) -
                       system.damping.cwiseProduct(speed));
  state.scheme = state.q / square - known;
  state.v = speed + of_damping * state.q;
  state.a = of_mass * state.q + acceleration;
}

}  // namespace

SmoothPath::SmoothPath(VectorXd time, std::vector<MatrixXd> values, double jump,
                       const std::vector<double>& bends, Slopes slopes)
    : time_(std::move(time)),
      values_(std::move(values)),
      jump_(jump),
      slopes_(slopes) {
  for (const double t : time_) {
    const auto near = std::ranges::lower_bound(bends, t - jump);
    is_bend_.push_back(near != bends.end() && *near <= t + jump);
  }
}

MatrixXd SmoothPath::secant(Index i) const {
  return (value(i + 1) - value(i)) / (time_[i + 1] - time_[i]);
}

bool SmoothPath::is_one_piece(Index i, Index next) const {
  return next >= 0 && next + 1 < time_.size() &&
         slopes_ != Slopes::kOfSecants &&
         time_[next + 1] - time_[next] > jump_ &&
         !is_bend_[static_cast<std::size_t>(std::max(i, next))];
}

MatrixXd SmoothPath::slope(Index i, Index next) const {
  const MatrixXd own = secant(i);
  const double length = time_[i + 1] - time_[i];
  if (is_one_piece(i, next)) {
    const MatrixXd other = secant(next);
    double of_own = time_[next + 1] - time_[next], of_other = length;
    if (slopes_ == Slopes::kLimited) {
      of_own *= other.squaredNorm();
      of_other *= own.squaredNorm();
    }
    const double sum = of_own + of_other;
    return sum > 0.0 ? MatrixXd((of_own * own + of_other * other) / sum)
                     : MatrixXd::Zero(own.rows(), own.cols());
  }
  const Index behind = 2 * i - next;
  if (!is_one_piece(i, behind)) return own;
  const MatrixXd turn = length / (length + time_[behind + 1] - time_[behind]) *
                        (own - secant(behind));
  return slopes_ == Slopes::kLimited && turn.norm() > own.norm()
             ? own
             : MatrixXd(own + turn);
}

SmoothPath::Piece SmoothPath::piece(Index i) const {
  const double length = time_[i + 1] - time_[i];
  const MatrixXd start = length * slope(i, i - 1);
  const MatrixXd end = length * slope(i, i + 1);
  const MatrixXd rise = value(i + 1) - value(i);
  Piece piece;
  piece.value_ = value(i);
  piece.first_ = start;
  piece.second_ = 3.0 * rise - 2.0 * start - end;
  piece.third_ = start + end - 2.0 * rise;
  return piece;
}

MatrixXd SmoothPath::at(double time) const {
  const Index i = interval(time);
  return piece(i).at((time - time_[i]) / (time_[i + 1] - time_[i]));
}

Index SmoothPath::interval(double time) const {
  const auto above = std::upper_bound(time_.begin(), time_.end(), time);
  return std::clamp<Index>(above - time_.begin() - 1, 0, time_.size() - 2);
}

MatrixXd SmoothPath::Piece::mean(double share) const {
  return value_ + share * (first_ / 2.0 +
                           share * (second_ / 3.0 + share * third_ / 4.0));
}

MatrixXd SmoothPath::Piece::at(double share) const {
  return value_ + share * (first_ + share * (second_ + share * third_));
}

VectorXd at_rest(const DiagonalSystem& system, const MatrixXd& rows,
                 const VectorXd& forces) {
  constexpr double kFree = 1e-8;  // of the least stiffness: held by rows alone
  const double most = system.stiffness.maxCoeff();
  double least = most;
  for (const double k : system.stiffness) {
    if (k > 0.0) least = std::min(least, k);
  }
  return solved(system.stiffness.cwiseMax(kFree * least), rows, forces);
}

void follow_at_rest(const DiagonalSystem& system, const SmoothPath& constraints,
                    const SmoothPath& forces, double step,
                    const TakeStep& take) {
  const Steps steps(constraints.time(), step);
  Walk rows(constraints), acting(forces);
  for (Index k = 0; k <= steps.count; ++k) {
    const double t = steps.end(k);
    take(t, at_rest(system, rows.at(t), acting.at(t)));
  }
}

void follow(const DiagonalSystem& system, const SmoothPath& constraints,
            const SmoothPath& forces, double step, const TakeStep& take) {
  const Steps steps(constraints.time(), step);
  const Means means(forces);
  Walk rows(constraints);
  State state;
  state.q = at_rest(system, constraints.value(0), forces.value(0));
  state.v = state.a = state.scheme = VectorXd::Zero(state.q.size());
  take(steps.from, state.q);
  for (Index k = 1; k <= steps.count; ++k) {
    const double t = steps.end(k);
    take_step(system, rows.at(t),
              means.over(t - 0.5 * steps.length, t + 0.5 * steps.length),
              steps.length, state);
    take(t, state.q);
  }
}

}  // namespace clevis::dynamics
