#include "mechanism/change_points/rank_loss_detector.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "numerics/curves/brent.h"
#include "numerics/factors/jacobian_factor.h"

namespace clevis::mechanism {

using Eigen::Index;

namespace {

constexpr std::size_t kHalvings = 40;
// Of one look; rows that fade in the noise of a dead end are never clear.
constexpr int kMostSplits = 1000;
constexpr int kMostChoices = 8;
// Below this a vector's direction is not known well; beyond a zero it grows.
constexpr double kClear = 1e-4;
// Into a near-singular interval from a direction at most so many times that far
// from zero.
constexpr double kBeside = 4.0;
// Two zeros in a row leave the directions as they were: where one may have
// been reached, parts of at most this are looked at.
constexpr double kLongest = 0.125;
// Zeros of several rows in one near-singular interval nearer than this part of
// it are one.
constexpr double kSame = 0.25;

}  // namespace

RankLossDetector::RankLossDetector(int rows, int columns, int rank,
                                   double error)
    : rows_(rows, columns, rank),
      clear_(std::max(kClear, error)),
      last_(rows_.frame()),
      probe_(last_),
      ahead_(kHalvings, last_),
      near_singular_(rank) {
  zeros_.reserve(static_cast<std::size_t>(rank));
}

bool RankLossDetector::start(const TimedJacobian& jacobian, double t) {
  from_ = last_.t = t;
  if (rows_.loses_rank(jacobian, t)) return true;
  rows_.choose(jacobian, t);
  rows_.measure(jacobian, t, last_);
  started_ = last_.sizes.size() == 0 ||
             last_.sizes.minCoeff() > numerics::kRankThreshold;
  return false;
}

RankLossDetector::Change RankLossDetector::compare(
    const RowDirections& next) const {
  bool is_opposite = false;
  double turned = 0.0;
  for (Index i = 0; i < rows_.rank(); ++i) {
    const double cosine = last_.directions.col(i).dot(next.directions.col(i));
    turned = std::max(turned, 1.0 - cosine);
    if (cosine > kSameDirection) continue;
    if (cosine > -kSameDirection) return Change::kUnclear;
    is_opposite = true;
  }
  if (is_opposite) return Change::kFlip;
  // 1 − cos of an angle larger than the way to zero and back
  const double way = last_.sizes.minCoeff() + next.sizes.minCoeff();
  return 2.0 * turned > way * way ? Change::kReach : Change::kNone;
}

void RankLossDetector::take_next() {
  std::swap(last_, next());
  --count_;
}

/// Puts a clear time between the last one and the next ahead.
bool RankLossDetector::split() {
  constexpr double kParts[] = {0.5, 0.3, 0.7};
  const double from = last_.t, part = next().t - from;
  const double shortest =
      std::ldexp(1.0, -static_cast<int>(kHalvings)) * (ahead_[0].t - from_);
  if (count_ == ahead_.size() || part < shortest || splits_left_ <= 0) {
    return false;
  }
  for (const double at : kParts) {
    --splits_left_;
    rows_.measure(*jacobian_, from + at * part, ahead_[count_]);
    if (!is_clear(ahead_[count_])) continue;
    ++count_;
    return true;
  }
  return false;
}

/// Whether other rows are clear at t where those that count are not.
bool RankLossDetector::finds_other_rows(double t) {
  if (!rows_.has_others() || near_singular_.is_open() || choices_left_ <= 0)
    return false;
  if (rows_.best_size(*jacobian_, t) <= clear_) return false;
  --choices_left_;
  rows_.choose(*jacobian_, t);
  rows_.measure(*jacobian_, last_.t, last_);
  if (!is_clear(last_)) {
    choices_left_ = 0;
    rows_.choose(*jacobian_, last_.t);
    rows_.measure(*jacobian_, last_.t, last_);
  }
  for (std::size_t k = 0; k < count_; ++k) {
    rows_.measure(*jacobian_, ahead_[k].t, ahead_[k]);
  }
  return true;
}

/// The part of r_i along its last clear direction.
double RankLossDetector::along_last(Index i, double t) {
  rows_.measure(*jacobian_, t, probe_);
  return probe_.sizes[i] *
         probe_.directions.col(i).dot(last_.directions.col(i));
}

/// Where that passes zero. @param sign  that it has at `from`.
double RankLossDetector::root(Index i, double from, double to, double sign) {
  const auto value = [&](double t) {
    return sign * along_last(i, t);
  };
  const double at_from = value(from), at_to = value(to);
  if (at_from <= 0.0) return from;
  if (at_to > 0.0) return to;
  return numerics::brent_root(value, from, at_from, to, at_to);
}

/// Of loops that lose rank together, zeros differ by the states' error.
void RankLossDetector::note(Index i, double zero) {
  for (std::size_t k = 0; k < zeros_.size(); ++k) {
    if (zeros_[k] < from_) continue;
    rows_.measure(*jacobian_, 0.5 * (zeros_[k] + zero), probe_);
    if (probe_.sizes[i] <= clear_ && probe_.sizes[of_row_[k]] <= clear_) {
      return;
    }
  }
  zeros_.push_back(zero);
  of_row_.push_back(i);
}

/// Notes the zeros from the last time to the next. @return false if that has to
/// be looked at anew, as a vector has only turned round or as other rows count.
bool RankLossDetector::pass_zeros() {
  for (Index i = 0; i < rows_.rank(); ++i) {
    const auto q = last_.directions.col(i);
    if (q.dot(next().directions.col(i)) > -kSameDirection) continue;
    const double zero = root(i, last_.t, next().t, 1.0);
    rows_.measure(*jacobian_, zero, probe_);
    if (probe_.sizes[i] > clear_) {
      if (split()) return false;
      continue;
    }
    if (finds_other_rows(zero)) return false;
    note(i, zero);
  }
  return true;
}

/// Records a sign change of row i within the near-singular interval as a
/// provisional zero.
void RankLossDetector::await(Index i, double from) {
  const double cosine = last_.directions.col(i).dot(next().directions.col(i));
  const double before = near_singular_.sign(i);
  if ((cosine < 0.0) == (before < 0.0)) return;
  near_singular_.note(i, root(i, from, next().t, before));
}

/// Enters a near-singular interval, or goes on in it: at the end of the look
/// directions are not clear.
void RankLossDetector::enter_near_singular() {
  const double from = near_singular_.is_open() ? from_ : last_.t;
  near_singular_.enter();
  for (Index i = 0; i < rows_.rank(); ++i) await(i, from);
  --count_;
}

/// Confirms the middle one of the provisional zeros of row i, of which there is
/// an odd number.
/// @param apart  zeros nearer than that are one change point [s].
void RankLossDetector::confirm_awaited(Index i, double apart) {
  const std::optional<double> zero = near_singular_.middle_zero(i);
  if (!zero) return;
  const bool is_known = std::ranges::any_of(zeros_, [&](double other) {
    return std::abs(other - *zero) < apart;
  });
  if (is_known) return;
  zeros_.push_back(*zero);
  of_row_.push_back(i);
}

/// Leaves the near-singular interval. The first clear directions behind it
/// decide which rows have passed zero, however often errors changed their signs
/// within.
void RankLossDetector::leave_near_singular() {
  constexpr int kShortest = 20;
  RowDirections& behind = ahead_[count_];
  for (int k = count_ < ahead_.size() ? kShortest : 0; k > 0; --k) {
    const double t = from_ + std::ldexp(next().t - from_, -k);
    rows_.measure(*jacobian_, t, behind);
    if (!is_clear(behind)) continue;
    ++count_;
    break;
  }
  for (Index i = 0; i < rows_.rank(); ++i) {
    await(i, from_);
    const auto q = last_.directions.col(i);
    if (q.dot(next().directions.col(i)) < -kSameDirection) {
      confirm_awaited(i, kSame * (next().t - last_.t));
    }
  }
  near_singular_.leave();
  take_next();
}

void RankLossDetector::follow() {
  if (!is_clear(next())) {
    if (finds_other_rows(next().t)) return;
    const bool is_far =
        !near_singular_.is_open() && last_.sizes.minCoeff() > kBeside * clear_;
    if (count_ > 1) {
      --count_;  // others serve
    } else if (!(is_far && split())) {
      enter_near_singular();
    }
    return;
  }
  if (near_singular_.is_open()) return leave_near_singular();
  const Change change = compare(next());
  const bool is_long = next().t - last_.t > kLongest * (ahead_[0].t - from_);
  const bool halve =
      change == Change::kUnclear || (change == Change::kReach && is_long);
  if (halve && split()) return;
  if (change == Change::kFlip && !pass_zeros()) return;
  take_next();
}

const std::vector<double>& RankLossDetector::look(const TimedJacobian& jacobian,
                                                  double t, double fastest) {
  zeros_.clear();
  of_row_.clear();
  if (rows_.rank() == 0 || !(t > from_)) return zeros_;
  jacobian_ = &jacobian;
  if (!started_) {
    start(jacobian, t);
    return zeros_;
  }
  splits_left_ = kMostSplits;
  choices_left_ = kMostChoices;
  rows_.measure(jacobian, t, ahead_[0]);
  count_ = 1;
  // directions may turn round and back between
  const double left = last_.sizes.minCoeff() + ahead_[0].sizes.minCoeff();
  if (!near_singular_.is_open() && left < fastest * (t - last_.t)) split();
  while (count_ > 0) follow();
  std::ranges::sort(zeros_);
  from_ = t;
  if (rows_.has_others() &&
      !near_singular_.is_open()) {  // others may be the clearer by now
    rows_.choose(jacobian, t);
    rows_.measure(jacobian, t, last_);
  }
  return zeros_;
}

const std::vector<double>& RankLossDetector::finish() {
  zeros_.clear();
  of_row_.clear();
  for (Index i = 0; i < rows_.rank() && near_singular_.is_open(); ++i) {
    if (near_singular_.sign(i) < 0.0) {
      confirm_awaited(i, kSame * (from_ - last_.t));
    }
  }
  near_singular_.leave();
  started_ = false;
  std::ranges::sort(zeros_);
  return zeros_;
}

}  // namespace clevis::mechanism
