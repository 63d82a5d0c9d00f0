#include "mechanism/sampling/load_list.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace clevis::mechanism {

using Eigen::Index;
using Eigen::VectorXd;

LoadList::LoadList(const ConstraintSystem& system, const Configuration& x,
                   const ForceModel& forces)
    : joints_(static_cast<int>(system.place(x).size())),
      drives_(system.rows() - system.joint_rows()) {
  for (int i = 0; i < system.joint_rows(); ++i) {
    const auto& row = system.row_list()[static_cast<std::size_t>(i)];
    // the efforts of couplings act through the joints' own frames
    vector_of_.push_back(row.coupling >= 0    ? -1
                         : row.row.is_angle() ? moment_of_joint(row.joint)
                                              : force_of_joint(row.joint));
  }
  for (int k = 0; k < drives_; ++k) vector_of_.push_back(drive(k));
  const auto elements = static_cast<int>(forces.size());
  for (int k = 0; k < elements; ++k) {
    vector_of_.insert(vector_of_.end(), 2, element(k));
  }
  vectors_ = element(elements);
}

LoadList::LoadList(const Instant& instant)
    : joints_(static_cast<int>(instant.joints.size())),
      drives_(static_cast<int>(instant.drives.size())) {
  for (int j = 0; j < joints_; ++j) {
    vector_of_.insert(vector_of_.end(), 3, force_of_joint(j));
    vector_of_.insert(vector_of_.end(), 3, moment_of_joint(j));
  }
  for (int k = 0; k < drives_; ++k) vector_of_.push_back(drive(k));
  const auto elements = static_cast<int>(instant.elements.size());
  for (int k = 0; k < elements; ++k) {
    vector_of_.insert(vector_of_.end(), 2, element(k));
  }
  vectors_ = element(elements);
}

void LoadList::get(const ConstraintSystem& system, const VectorXd& multipliers,
                   const ForceState& acting, VectorXd& values) const {
  values.resize(size());
  Index at = 0;
  for (; at < system.rows(); ++at) {
    values[at] = system.multiplier(
        system.row_list()[static_cast<std::size_t>(at)], multipliers[at]);
  }
  for (const ElementResponse& element : acting.elements) {
    values[at++] = element.effort;
    values[at++] = element.friction;
  }
}

void LoadList::get(const Instant& instant, VectorXd& values) const {
  values.resize(size());
  Index at = 0;
  for (const JointReaction& joint : instant.joints) {
    values.segment<3>(at) = joint.f_W;
    values.segment<3>(at + 3) = joint.t_W;
    at += 6;
  }
  for (const DriveState& drive : instant.drives) values[at++] = drive.effort;
  for (const ElementState& element : instant.elements) {
    values[at++] = element.effort;
    values[at++] = element.friction;
  }
}

void LoadList::squares(const VectorXd& values, VectorXd& squares) const {
  squares.setZero(vectors_);
  for (Index i = 0; i < size(); ++i) {
    const Index v = vector_of_[static_cast<std::size_t>(i)];
    if (v >= 0) squares[v] += values[i] * values[i];
  }
}

void LoadList::squares_of_change(const VectorXd& a, const VectorXd& b,
                                 VectorXd& squares) const {
  squares.setZero(vectors_);
  for (Index i = 0; i < size(); ++i) {
    const Index v = vector_of_[static_cast<std::size_t>(i)];
    if (v >= 0) squares[v] += (a[i] - b[i]) * (a[i] - b[i]);
  }
}

namespace {

// Below this part of the largest a vector is round-off of the others.
constexpr double kRoundOff = 1e-6;
constexpr double kMatters = 0.5;

/// How much a vector may change between instants, over its largest length.
double allowed(double level) {
  if (level < kMatters) return 4.0;  // more than it can
  return level < 0.8 ? 0.05 : level < 0.95 ? 0.02 : 0.005;
}

}  // namespace

LoadChange::LoadChange(const LoadList& list, VectorXd largest,
                       double coarseness)
    : list_(list), largest_(std::move(largest)), coarseness_(coarseness) {
  const double most = largest_.size() > 0 ? largest_.maxCoeff() : 0.0;
  largest_ =
      (largest_.array() > kRoundOff * kRoundOff * most).select(largest_, 0.0);
  for (VectorXd* v : {&at_a_, &at_b_, &change_}) v->setZero(list.vectors());
}

bool LoadChange::is_large(const VectorXd& a, const VectorXd& b) {
  list_.squares(a, at_a_);
  list_.squares(b, at_b_);
  list_.squares_of_change(a, b, change_);
  for (Index v = 0; v < largest_.size(); ++v) {
    if (!(largest_[v] > 0.0)) continue;
    const double level = std::sqrt(std::max(at_a_[v], at_b_[v]) / largest_[v]);
    if (std::sqrt(change_[v] / largest_[v]) > coarseness_ * allowed(level)) {
      return true;
    }
  }
  return false;
}

void LoadChange::over_largest(const VectorXd& a, const VectorXd& b,
                              VectorXd& squares) const {
  list_.squares_of_change(a, b, squares);
  for (Index v = 0; v < largest_.size(); ++v) {
    squares[v] = largest_[v] > 0.0 ? squares[v] / largest_[v] : 0.0;
  }
}

}  // namespace clevis::mechanism
