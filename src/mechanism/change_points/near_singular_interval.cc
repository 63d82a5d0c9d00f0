#include "mechanism/change_points/near_singular_interval.h"

namespace clevis::mechanism {

void NearSingularInterval::enter() {
  if (!is_open_) signs_.setOnes();
  is_open_ = true;
}

void NearSingularInterval::leave() {
  zeros_.clear();
  vectors_.clear();
  is_open_ = false;
}

void NearSingularInterval::note(Eigen::Index i, double zero) {
  zeros_.push_back(zero);
  vectors_.push_back(i);
  signs_[i] = -signs_[i];
}

std::optional<double> NearSingularInterval::middle_zero(Eigen::Index i) const {
  std::vector<double> own;
  for (std::size_t k = 0; k < zeros_.size(); ++k) {
    if (vectors_[k] == i) own.push_back(zeros_[k]);
  }
  if (own.empty()) return std::nullopt;
  return own[own.size() / 2];
}

}  // namespace clevis::mechanism
