// Of RankLossDetector: what is found where directions are not clear.
#include <algorithm>
#include <cmath>

#include "mechanism/change_points/rank_loss_detector.h"

namespace clevis::mechanism {

using Eigen::Index;

namespace {

// Part of a near-singular interval within which zeros of several rows are one.
constexpr double kSame = 0.25;

}  // namespace

/// Records a sign change of row i within the near-singular interval as a
/// provisional zero.
void RankLossDetector::await(Index i, double from) {
  const double cosine = last_.directions.col(i).dot(next().directions.col(i));
  const double sign = cosine < 0.0 ? -1.0 : 1.0;
  if (sign == signs_[i]) return;
  awaited_.push_back(root(i, from, next().t, signs_[i]));
  awaited_rows_.push_back(i);
  signs_[i] = sign;
}

/// Enters a near-singular interval, or goes on in it: at the end of the look
/// directions are not clear.
void RankLossDetector::enter_near_singular() {
  const double from = near_singular_ ? from_ : last_.t;
  if (!near_singular_) signs_.setOnes();
  near_singular_ = true;
  for (Index i = 0; i < rows_.rank(); ++i) await(i, from);
  --count_;
}

/// Confirms the middle one of the provisional zeros of row i, of which there is
/// an odd number.
/// @param apart  zeros nearer than that are one change point [s].
void RankLossDetector::confirm_awaited(Index i, double apart) {
  std::vector<double> own;
  for (std::size_t k = 0; k < awaited_.size(); ++k) {
    if (awaited_rows_[k] == i) own.push_back(awaited_[k]);
  }
  if (own.empty()) return;
  const double zero = own[own.size() / 2];
  const bool is_known = std::ranges::any_of(zeros_, [&](double other) {
    return std::abs(other - zero) < apart;
  });
  if (is_known) return;
  zeros_.push_back(zero);
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
  awaited_.clear();
  awaited_rows_.clear();
  near_singular_ = false;
  take_next();
}

const std::vector<double>& RankLossDetector::finish() {
  zeros_.clear();
  of_row_.clear();
  for (Index i = 0; i < rows_.rank() && near_singular_; ++i) {
    if (signs_[i] < 0.0) confirm_awaited(i, kSame * (from_ - last_.t));
  }
  awaited_.clear();
  awaited_rows_.clear();
  near_singular_ = started_ = false;
  std::ranges::sort(zeros_);
  return zeros_;
}

}  // namespace clevis::mechanism
