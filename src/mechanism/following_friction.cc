#include "mechanism/following_friction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <fmt/format.h>

#include "base/errors.h"

namespace clevis::mechanism {
namespace {

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::VectorXd;

constexpr double kSettled = 1e-13;  // of the largest effort

/// The joint on which the load of an element depends, or −1.
int followed_joint(const ForceElement& element) {
  const auto* line = std::get_if<LineElement>(&element);
  const auto* law = line ? std::get_if<FrictionLaw>(&line->law) : nullptr;
  return law != nullptr && law->follows_reaction ? line->line.joint : -1;
}

}  // namespace

FollowingFriction::FollowingFriction(const ForceModel& forces,
                                     const ConstraintSystem& system,
                                     int columns, int most_rows)
    : system_(system) {
  for (std::size_t k = 0; k < forces.size(); ++k) {
    const int joint = followed_joint(*forces.element(k).definition);
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
                                ConstrainedMass& mass) {
  levers_.setZero();
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const auto at = static_cast<Index>(i);
    const ActingElement& e = forces.element(lines_[i].element);
    lines_[i].per_load = e.per_load;
    if (e.per_load == 0.0) {
      accelerations_.col(at).setZero();
      multipliers_.col(at).setZero();
      continue;
    }
    system_.add_levers(levers_, static_cast<int>(i), e.line.a, e.line.b,
                       e.levers, 1.0);
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

double FollowingFriction::solve(ForceModel& forces, ConstrainedMass& mass,
                                VectorXd& a, VectorXd& lambda) {
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    lines_[i].free = reaction(i, lambda);
  }
  respond(forces, mass);
  jams_ = !contracts() || !find_efforts();
  if (jams_) return std::numeric_limits<double>::quiet_NaN();
  a.noalias() += accelerations_ * efforts_;
  lambda.noalias() += multipliers_ * efforts_;
  double power = 0.0;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const std::size_t k = lines_[i].element;
    forces.set_load(k, reaction(i, lambda).norm());
    power += efforts_[static_cast<Index>(i)] * forces.element(k).rate;
  }
  return power;
}

Equilibrium::Solution balance_with_friction(
    ForceModel& forces, std::size_t slots,
    const std::function<Equilibrium::Solution(std::span<const Twist>)>&
        balance) {
  constexpr int kMost = 300;
  std::vector<Twist> applied(slots);
  forces.add_to(applied);
  Equilibrium::Solution solution = balance(applied);
  for (int i = 0; i < kMost; ++i) {
    double change = 0.0, largest = 0.0;
    for (std::size_t k = 0; k < forces.size(); ++k) {
      const int joint = followed_joint(*forces.element(k).definition);
      if (joint < 0) continue;
      const auto& reaction = solution.joints[static_cast<std::size_t>(joint)];
      const double before = forces.element(k).load;
      forces.set_load(k, reaction.components().head<2>().norm());
      const double load = forces.element(k).load;
      change = std::max(change, std::abs(load - before));
      largest = std::max(largest, load);
    }
    if (!std::isfinite(largest)) break;
    if (change <= kSettled * largest) return solution;
    std::ranges::fill(applied, Twist{});
    forces.add_to(applied);
    solution = balance(applied);
  }
  throw Error("K011", "mechanism",
              "joint friction that follows the reaction grows with it without "
              "bound",
              "reduce the friction coefficient or the pin radius, or drive "
              "another joint");
}

namespace {

bool some_friction_rests(const ForceModel& forces) {
  for (std::size_t k = 0; k < forces.size(); ++k) {
    if (forces.is_dry(k) && std::abs(forces.element(k).modes[0]) != 1) {
      return true;
    }
  }
  return false;
}

/// Whether equilibrium leaves open the reaction that an element follows.
bool is_open(const ForceElement& element,
             const std::vector<JointReaction>& joints) {
  const int followed = followed_joint(element);
  if (followed < 0) return false;
  const auto& unique =
      joints[static_cast<std::size_t>(followed)].unique_components;
  return !unique[0] || !unique[1];
}

/// Whether friction at rest holds more than the reaction lets it, as the
/// compliances share that.
bool exceeds_its_most(const ForceElement& element, const ActingElement& acting,
                      const std::vector<JointReaction>& joints) {
  constexpr double kMargin = 1e-6;
  const auto j = static_cast<std::size_t>(followed_joint(element));
  const double load = joints[j].components().head<2>().norm();
  const double most = switched_friction(element)->breakaway * load;
  return std::abs(acting.effort) > (1.0 + kMargin) * most;
}

[[noreturn]] void refuse_open_load(const MechanismDefinition& definition,
                                   const ForceModel& forces, std::size_t k) {
  const ForceElement& element = definition.elements[k];
  const auto j = static_cast<std::size_t>(followed_joint(element));
  const bool rests = some_friction_rests(forces);
  throw Error("K011", std::get<LineElement>(element).place,
              fmt::format("friction {} follows the reaction of joint {}, "
                          "which equilibrium leaves open{}",
                          name_of(element), definition.joints[j].name,
                          rests ? ": friction at rest shares it" : ""),
              rests ? "give the friction itself, or model = \"regularized\"; "
                      "remove redundant constraints if there are any"
                    : "remove redundant constraints (dimension = \"planar\" if "
                      "the mechanism moves in a plane), or give the friction "
                      "itself");
}

}  // namespace

void require_unique_loads(const MechanismDefinition& definition,
                          const ForceModel& forces,
                          const std::vector<JointReaction>& joints) {
  for (std::size_t k = 0; k < definition.elements.size(); ++k) {
    const ForceElement& element = definition.elements[k];
    if (!is_open(element, joints)) continue;
    const bool slides = std::abs(forces.element(k).modes[0]) == 1;
    const bool fails =
        slides || (forces.is_dry(k) &&
                   exceeds_its_most(element, forces.element(k), joints));
    if (fails) refuse_open_load(definition, forces, k);
  }
}

void refuse_open_loads(const MechanismDefinition& definition,
                       const ForceModel& forces,
                       const std::vector<JointReaction>& joints) {
  for (std::size_t k = 0; k < definition.elements.size(); ++k) {
    if (is_open(definition.elements[k], joints)) {
      refuse_open_load(definition, forces, k);
    }
  }
}

void refuse_jam(double t) {
  throw Error("K011", "mechanism",
              fmt::format("at t = {:.9g} s joint friction that follows the "
                          "reaction jams: no friction, or more than one, fits "
                          "the motion",
                          t),
              "reduce the friction coefficient or the pin radius; rigid "
              "bodies have no answer here");
}

}  // namespace clevis::mechanism
