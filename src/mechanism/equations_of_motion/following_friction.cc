#include "mechanism/equations_of_motion/following_friction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <fmt/format.h>

#include "mechanism/forces/given_efforts.h"
#include "mechanism/reactions/reaction_friction.h"

namespace clevis::mechanism {
namespace {

using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::VectorXd;

constexpr double kSettled = 1e-13;  // of the largest effort

// Rows across the axis of a joint.
bool is_force(const ConstraintSystem::Row& row) {
  return row.row.kind == JointRow::Kind::kTranslation && row.row.axis < 2;
}
bool is_moment(const ConstraintSystem::Row& row) {
  return row.row.kind == JointRow::Kind::kRotation && row.row.axis < 2;
}

/// Of the columns' sizes together, by a change of them.
double growth_of_sizes(const Matrix2d& columns, const Matrix2d& change) {
  double growth = 0.0;
  for (Index c = 0; c < 2; ++c) {
    const double size = columns.col(c).norm();
    if (size > 0.0) growth += columns.col(c).dot(change.col(c)) / size;
  }
  return growth;
}

}  // namespace

FollowingFriction::FollowingFriction(const ForceModel& forces,
                                     const ConstraintSystem& system,
                                     int columns, int most_rows)
    : system_(system) {
  for (std::size_t k = 0; k < forces.size(); ++k) {
    const int joint = forces.element(k).followed_joint();
    if (joint < 0) continue;
    Line line{.element = k, .rows = {}, .guide = forces.element(k).guide()};
    for (int i = 0; i < system.joint_rows(); ++i) {
      const auto& row = system.row_list()[static_cast<std::size_t>(i)];
      const bool is_across =
          is_force(row) || (line.guide.length > 0.0 && is_moment(row));
      if (row.joint == joint && row.coupling < 0 && is_across) {
        line.rows.push_back(i);
      }
    }
    lines_.push_back(line);
  }
  const auto count = static_cast<Index>(lines_.size());
  levers_.setZero(count, columns);
  accelerations_.setZero(columns, count);
  multipliers_.setZero(most_rows, count);
  newton_.setZero(count, count);
  lu_ = Eigen::PartialPivLU<Eigen::MatrixXd>(count);
  for (VectorXd* v : {&none_, &lambda_}) v->setZero(most_rows);
  for (VectorXd* v : {&Q_, &a_}) v->setZero(columns);
  for (VectorXd* v : {&efforts_, &rest_, &growth_}) v->setZero(count);
}

Matrix2d FollowingFriction::pressing(std::size_t line,
                                     const VectorXd& lambda) const {
  JointLoad load = JointLoad::Zero();
  const Line& of = lines_[line];
  for (const int i : of.rows) {
    const auto& row = system_.row_list()[static_cast<std::size_t>(i)];
    const int axis = row.row.axis + (is_moment(row) ? 3 : 0);
    load[axis] = system_.multiplier(row, lambda[i]);
  }
  return end_forces(of.guide, of.q, load);
}

/// Accelerations and multipliers of one unit of each effort alone.
void FollowingFriction::respond(const ForceModel& forces,
                                const ForceState& acting,
                                ConstrainedMass& mass) {
  levers_.setZero();
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const auto at = static_cast<Index>(i);
    const JointModel& line = forces.element(lines_[i].element).line;
    const ElementResponse& e = acting.elements[lines_[i].element];
    lines_[i].per_load = e.per_load;
    if (e.per_load == 0.0) {
      accelerations_.col(at).setZero();
      multipliers_.col(at).setZero();
      continue;
    }
    system_.add_levers(levers_, static_cast<int>(i), line.a, line.b, e.levers,
                       1.0);
    Q_ = levers_.row(at).transpose();
    mass.accelerate(none_, Q_, a_, lambda_);
    accelerations_.col(at) = a_;
    multipliers_.col(at) = lambda_;
  }
}

/// Whether each effort changes the others by less than itself, whatever their
/// directions: then there is one solution and no other. By powers of the
/// matrix of the largest changes.
bool FollowingFriction::contracts() {
  for (Index i = 0; i < newton_.rows(); ++i) {
    const auto line = static_cast<std::size_t>(i);
    for (Index j = 0; j < newton_.cols(); ++j) {
      lambda_ = multipliers_.col(j);
      newton_(i, j) = std::abs(lines_[line].per_load) *
                      pressing_force(pressing(line, lambda_));
    }
  }
  efforts_.setOnes();
  double growth = 0.0;
  for (int i = 0; i < 30; ++i) {
    growth_.noalias() = newton_ * efforts_;
    growth = growth_.maxCoeff();
    if (!(growth > 0.0)) return true;
    efforts_ = growth_ / growth;
    // no line may drop out: it might grow again
    efforts_ = efforts_.cwiseMax(1e-12);
  }
  return growth < 1.0;
}

/// Newton's method; each effort is its factor times the sizes of forces that
/// are linear in all efforts.
bool FollowingFriction::find_efforts() {
  constexpr int kMost = 50;
  efforts_.setZero();
  for (int iteration = 0; iteration < kMost; ++iteration) {
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const auto at = static_cast<Index>(i);
      lambda_.noalias() = multipliers_ * efforts_;
      const Matrix2d ends = lines_[i].free + pressing(i, lambda_);
      const double factor = lines_[i].per_load;
      rest_[at] = efforts_[at] - factor * pressing_force(ends);
      for (Index j = 0; j < newton_.cols(); ++j) {
        lambda_ = multipliers_.col(j);
        const double change = growth_of_sizes(ends, pressing(i, lambda_));
        newton_(at, j) = (at == j ? 1.0 : 0.0) - factor * change;
      }
    }
    lu_.compute(newton_);
    growth_ = lu_.solve(rest_);
    efforts_ -= growth_;
    const double size = efforts_.lpNorm<Eigen::Infinity>();
    if (!std::isfinite(size)) return false;
    if (growth_.lpNorm<Eigen::Infinity>() <= kSettled * size) return true;
  }
  return false;
}

double FollowingFriction::solve(const ForceModel& forces, ConstrainedMass& mass,
                                ForceState& acting, VectorXd& a,
                                VectorXd& lambda) {
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    lines_[i].q = acting.elements[lines_[i].element].q;
    lines_[i].free = pressing(i, lambda);
  }
  respond(forces, acting, mass);
  self_locking_.reset();
  if (!contracts() || !find_efforts()) {
    Index fastest = 0;
    growth_.cwiseAbs().maxCoeff(&fastest);
    self_locking_ = lines_[static_cast<std::size_t>(fastest)].element;
    return std::numeric_limits<double>::quiet_NaN();
  }
  a.noalias() += accelerations_ * efforts_;
  lambda.noalias() += multipliers_ * efforts_;
  double power = 0.0;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const std::size_t k = lines_[i].element;
    give_load(forces.element(k), pressing_force(pressing(i, lambda)),
              acting.elements[k]);
    power += efforts_[static_cast<Index>(i)] * acting.elements[k].rate;
  }
  return power;
}

}  // namespace clevis::mechanism
