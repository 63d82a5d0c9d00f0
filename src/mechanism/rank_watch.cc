#include "mechanism/rank_watch.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/QR>

#include "mechanism/brent.h"
#include "mechanism/jacobian_factor.h"

namespace clevis::mechanism {

using Eigen::Index;
using Eigen::MatrixXd;

namespace {

constexpr std::size_t kHalvings = 40;
// Of one step; rows that fade in the noise of a dead end are never clear.
constexpr int kMostLooks = 1000;
// Below this a vector's direction is not known well; beyond a zero it grows.
constexpr double kClear = 1e-4;
// A zero found to round-off of the states in between.
constexpr double kZero = 3e-5;
// What corrections beside a zero may move, at the border of steps.
constexpr double kBorder = 1e-3, kJump = 1e-2;
constexpr double kAgree = 0.5;  // cosine
constexpr double kNear = 0.5;   // sizes beside a zero
// Two zeros in a row leave the directions as they were: where one may have
// been reached, parts of at most this are looked at.
constexpr double kLongest = 0.125;

}  // namespace

RankWatch::RankWatch(int rows, int columns, int rank, double error)
    : rank_(rank),
      zero_(std::max(kZero, error)),
      J_(MatrixXd::Zero(rows, columns)) {
  const auto reserve = [&](Frame& frame) {
    frame.directions.setZero(columns, rank);
    frame.sizes.setZero(rank);
  };
  ahead_.resize(kHalvings);
  reserve(last_);
  reserve(probe_);
  for (Frame& frame : ahead_) reserve(frame);
  order_.reserve(static_cast<std::size_t>(rows));
  zeros_.reserve(static_cast<std::size_t>(rank));
}

/// The rows that are the farthest from depending on one another.
void RankWatch::choose_rows(const Jacobian& jacobian, double t) {
  jacobian(t, J_);
  order_.clear();
  if (J_.rows() == rank_) {
    for (Index i = 0; i < rank_; ++i) order_.push_back(i);
    return;
  }
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(J_.transpose());
  for (Index i = 0; i < rank_; ++i) {
    order_.push_back(qr.colsPermutation().indices()[i]);
  }
}

void RankWatch::measure(const Jacobian& jacobian, double t, Frame& frame) {
  jacobian(t, J_);
  frame.t = t;
  for (Index i = 0; i < rank_; ++i) {
    auto r = frame.directions.col(i);
    r = J_.row(order_[static_cast<std::size_t>(i)]).transpose();
    const double length = r.norm();
    for (Index j = 0; j < i; ++j) {
      const auto q = frame.directions.col(j);
      r -= q.dot(r) * q;
    }
    const double left = r.norm();
    frame.sizes[i] = length > 0.0 ? left / length : 0.0;
    if (left > 0.0) r /= left;
  }
}

bool RankWatch::regular(const Frame& frame) const {
  return rank_ == 0 || frame.sizes.minCoeff() > kClear;
}

bool RankWatch::start(const Jacobian& jacobian, double t) {
  jacobian(t, J_);
  if (numerical_rank(J_) < rank_) return true;
  choose_rows(jacobian, t);
  measure(jacobian, t, last_);
  started_ = regular(last_);
  return false;
}

/// @param flipped  the first direction from `after` on that is opposite.
RankWatch::Change RankWatch::compare(const Frame& from, const Frame& to,
                                     Index& flipped, Index after) const {
  flipped = -1;
  double turned = 0.0;
  for (Index i = after; i < rank_; ++i) {
    const double cosine = from.directions.col(i).dot(to.directions.col(i));
    turned = std::max(turned, 1.0 - cosine);
    if (cosine > kAgree) continue;
    // one that is opposite without having been small has only turned round
    if (cosine > -kAgree || std::max(from.sizes[i], to.sizes[i]) > kNear) {
      return Change::kUnclear;
    }
    if (flipped < 0) flipped = i;
  }
  if (flipped >= 0) return Change::kFlip;
  // 1 − cos of an angle larger than the way to zero and back
  const double way = from.sizes.minCoeff() + to.sizes.minCoeff();
  return 2.0 * turned > way * way ? Change::kReach : Change::kNone;
}

void RankWatch::find_zeros(const Jacobian& jacobian, const Frame& from,
                           const Frame& to) {
  Index i = -1;
  for (Index after = 0; compare(from, to, i, after) == Change::kFlip;
       after = i + 1) {
    const auto signed_size = [&](double t) {
      measure(jacobian, t, probe_);
      const double cosine =
          probe_.directions.col(i).dot(from.directions.col(i));
      return cosine < 0.0 ? -probe_.sizes[i] : probe_.sizes[i];
    };
    const double t =
        brent_root(signed_size, from.t, from.sizes[i], to.t, -to.sizes[i]);
    const double size = std::abs(signed_size(t));
    // zero between states of one time: before and behind their correction
    const bool in_jump = t - from.t < kBorder * (to.t - from.t) &&
                         std::max(from.sizes[i], size) < kJump;
    // a vector that only passes close by turns round without being zero
    if (size > zero_ && !in_jump) continue;
    // nor do rows that others can stand in for
    if (!in_jump && J_.rows() > rank_ && numerical_rank(J_) == rank_) continue;
    // of loops that lose rank together, zeros differ by the states' error
    const bool is_known = std::ranges::any_of(zeros_, [&](double other) {
      measure(jacobian, 0.5 * (other + t), probe_);
      return !regular(probe_);
    });
    if (!is_known) zeros_.push_back(t);
  }
}

const std::vector<double>& RankWatch::look(const Jacobian& jacobian, double t,
                                           double fastest) {
  zeros_.clear();
  if (rank_ == 0 || !(t > last_.t)) return zeros_;
  if (!started_) {
    last_.t = t;
    start(jacobian, t);
    return zeros_;
  }
  measure(jacobian, t, ahead_[0]);
  if (!regular(ahead_[0])) return zeros_;  // judged from farther on
  std::size_t count = 1;
  // directions may turn round and back between
  const double left = last_.sizes.minCoeff() + ahead_[0].sizes.minCoeff();
  if (left < fastest * (t - last_.t)) {
    measure(jacobian, 0.5 * (last_.t + t), ahead_[count++]);
  }
  int looks = 0;
  const double shortest = std::ldexp(t - last_.t, -static_cast<int>(kHalvings));
  const double longest = kLongest * (t - last_.t);
  while (count > 0) {
    Frame& next = ahead_[count - 1];
    Index flipped = -1;
    const Change change = compare(last_, next, flipped, 0);
    const double part = next.t - last_.t;
    const bool halve = (change == Change::kUnclear && part > shortest) ||
                       (change == Change::kReach && part > longest);
    if (halve && count < ahead_.size() && looks++ < kMostLooks) {
      measure(jacobian, 0.5 * (last_.t + next.t), ahead_[count]);
      ++count;
      continue;
    }
    if (change == Change::kFlip) find_zeros(jacobian, last_, next);
    std::swap(last_, next);
    --count;
  }
  std::ranges::sort(zeros_);
  if (J_.rows() > rank_) {  // others may be the clearer ones by now
    choose_rows(jacobian, t);
    measure(jacobian, t, last_);
  }
  return zeros_;
}

}  // namespace clevis::mechanism
