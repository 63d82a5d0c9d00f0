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
using Eigen::Vector2d;
using Eigen::VectorXd;

constexpr double kSettled = 1e-13;  // of the largest effort

}  // namespace

FollowingFriction::FollowingFriction(const ForceModel& forces,
                                     const ConstraintSystem& system,
                                     int columns, int most_rows)
    : system_(system) {
  for (std::size_t k = 0; k < forces.size(); ++k) {
    const int joint = forces.element(k).followed_joint();
    if (joint < 0) continue;
    Line line{.element = k, .rows = {}};
    for (int i = 0; i < system.joint_rows(); ++i) {
      const auto& row = system.row_list()[static_cast<std::size_t>(i)];
      if (row.joint == joint && row.coupling < 0 &&
          row.row.kind == JointRow::Kind::kTranslation && row.row.axis < 2) {
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

Vector2d FollowingFriction::reaction(std::size_t line,
                                     const VectorXd& lambda) const {
  Vector2d f = Vector2d::Zero();
  const auto& rows = lines_[line].rows;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    f[static_cast<Index>(i)] = lambda[rows[i]];
  }
  return f;
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
      newton_(i, j) =
          std::abs(lines_[line].per_load) * reaction(line, lambda_).norm();
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

/// Newton's method; each effort is its factor times the size of a reaction
/// that is linear in all efforts.
bool FollowingFriction::find_efforts() {
  constexpr int kMost = 50;
  efforts_.setZero();
  for (int iteration = 0; iteration < kMost; ++iteration) {
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const auto at = static_cast<Index>(i);
      lambda_.noalias() = multipliers_ * efforts_;
      const Vector2d f = lines_[i].free + reaction(i, lambda_);
      const double size = f.norm(), factor = lines_[i].per_load;
      rest_[at] = efforts_[at] - factor * size;
      for (Index j = 0; j < newton_.cols(); ++j) {
        lambda_ = multipliers_.col(j);
        const double change =
            size > 0.0 ? f.dot(reaction(i, lambda_)) / size : 0.0;
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
    lines_[i].free = reaction(i, lambda);
  }
  respond(forces, acting, mass);
  is_self_locking_ = !contracts() || !find_efforts();
  if (is_self_locking_) return std::numeric_limits<double>::quiet_NaN();
  a.noalias() += accelerations_ * efforts_;
  lambda.noalias() += multipliers_ * efforts_;
  double power = 0.0;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const std::size_t k = lines_[i].element;
    give_load(forces.element(k), reaction(i, lambda).norm(),
              acting.elements[k]);
    power += efforts_[static_cast<Index>(i)] * acting.elements[k].rate;
  }
  return power;
}

}  // namespace clevis::mechanism
