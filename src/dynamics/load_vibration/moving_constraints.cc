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

/// Takes rows and forces at even parts of an interval, its start left out.
template <typename Take>
void walk(const SmoothPath& constraints, const SmoothPath& forces,
          Index interval, Index parts, const Take& take) {
  const VectorXd& time = constraints.time();
  const auto rows = constraints.piece(interval);
  const auto acting = forces.piece(interval);
  for (Index k = 1; k < parts; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(parts);
    take(time[interval] + share * (time[interval + 1] - time[interval]),
         rows.at(share), acting.at(share));
  }
  take(time[interval + 1], constraints.value(interval + 1),
       forces.value(interval + 1));
}

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
                       const std::vector<double>& bends,
                       LoadPath::Between between)
    : time_(std::move(time)),
      values_(std::move(values)),
      jump_(jump),
      between_(between) {
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
         between_ == LoadPath::Between::kCubic &&
         time_[next + 1] - time_[next] > jump_ &&
         !is_bend_[static_cast<std::size_t>(std::max(i, next))];
}

MatrixXd SmoothPath::slope(Index i, Index next) const {
  const MatrixXd own = secant(i);
  const double length = time_[i + 1] - time_[i];
  const auto turn = [&](Index other) -> MatrixXd {
    return (secant(other) - own) / (length + time_[other + 1] - time_[other]) *
           length;
  };
  if (is_one_piece(i, next)) return own + turn(next);
  const Index behind = 2 * i - next;
  return is_one_piece(i, behind) ? MatrixXd(own - turn(behind)) : own;
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
                    const SmoothPath& forces, int parts, const TakeStep& take) {
  const VectorXd& time = constraints.time();
  take(time[0], at_rest(system, constraints.value(0), forces.value(0)));
  for (Index i = 0; i + 1 < time.size(); ++i) {
    walk(constraints, forces, i, parts,
         [&](double t, const MatrixXd& rows, const MatrixXd& there) {
           take(t, at_rest(system, rows, there));
         });
  }
}

void follow(const DiagonalSystem& system, const SmoothPath& constraints,
            const SmoothPath& forces, double step, const TakeStep& take) {
  const VectorXd& time = constraints.time();
  State state;
  state.q = at_rest(system, constraints.value(0), forces.value(0));
  state.v = state.a = state.scheme = VectorXd::Zero(state.q.size());
  take(time[0], state.q);
  for (Index i = 0; i + 1 < time.size(); ++i) {
    const double length = time[i + 1] - time[i];
    if (!(length > 0.0)) continue;
    const auto count =
        std::max<Index>(1, static_cast<Index>(std::ceil(length / step)));
    const double h = length / static_cast<double>(count);
    walk(constraints, forces, i, count,
         [&](double t, const MatrixXd& rows, const MatrixXd& there) {
           take_step(system, rows, there, h, state);
           take(t, state.q);
         });
  }
}

}  // namespace clevis::dynamics
