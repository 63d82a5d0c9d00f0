// Of RankWatch: what is found where directions are not clear.
#include <algorithm>
#include <cmath>

#include "mechanism/change_points/rank_watch.h"

namespace clevis::mechanism {

using Eigen::Index;

namespace {

// Zeros of several rows in one haze nearer than this part of it are one.
constexpr double kSame = 0.25;

}  // namespace

/// In the haze a zero may have been passed from a time to the next.
void RankWatch::await(Index i, double from) {
  const double cosine = last_.directions.col(i).dot(next().directions.col(i));
  const double sign = cosine < 0.0 ? -1.0 : 1.0;
  if (sign == signs_[i]) return;
  awaited_.push_back(root(i, from, next().t, signs_[i]));
  awaited_rows_.push_back(i);
  signs_[i] = sign;
}

/// The look ends where directions are not clear.
void RankWatch::enter_haze() {
  const double from = in_haze_ ? from_ : last_.t;
  if (!in_haze_) signs_.setOnes();
  in_haze_ = true;
  for (Index i = 0; i < rows_.rank(); ++i) await(i, from);
  --count_;
}

/// Vector i has passed zero an odd number of times: in the middle one.
/// @param apart  zeros nearer than that are one change point [s].
void RankWatch::settle_awaited(Index i, double apart) {
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

/// The first clear directions behind say which vectors have passed zero, an odd
/// number of times, however often errors had them cross.
void RankWatch::leave_haze() {
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
      settle_awaited(i, kSame * (next().t - last_.t));
    }
  }
  awaited_.clear();
  awaited_rows_.clear();
  in_haze_ = false;
  take_next();
}

const std::vector<double>& RankWatch::finish() {
  zeros_.clear();
  of_row_.clear();
  for (Index i = 0; i < rows_.rank() && in_haze_; ++i) {
    if (signs_[i] < 0.0) settle_awaited(i, kSame * (from_ - last_.t));
  }
  awaited_.clear();
  awaited_rows_.clear();
  in_haze_ = started_ = false;
  std::ranges::sort(zeros_);
  return zeros_;
}

}  // namespace clevis::mechanism
