#include "elasticity/buckling/second_order_solver.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "dynamics/systems/block_krylov.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using State = SecondOrderSolver::State;

/// Solves y − A y = b by conjugate gradients: unstable where 1 is no bound of
/// A's eigenvalues.
/// @param wanted  norm of the residual.
State solve(const std::function<VectorXd(const VectorXd&)>& a,
            const VectorXd& b, double wanted, VectorXd& y) {
  constexpr int kMostSteps = 300;
  y = VectorXd::Zero(b.size());
  VectorXd residual = b, direction = b;
  double square = residual.squaredNorm();
  for (int step = 0; step < kMostSteps && square > wanted * wanted; ++step) {
    const VectorXd product = direction - a(direction);
    const double curvature = direction.dot(product);
    if (!(curvature > 0.0)) return State::kUnstable;
    const double length = square / curvature;
    y += length * direction;
    residual -= length * product;
    const double before = square;
    square = residual.squaredNorm();
    direction = residual + square / before * direction;
  }
  return square <= wanted * wanted ? State::kStable : State::kOpen;
}

/// Ω² I − Ω Ωᵀ: what a mass is driven out by as it moves.
Matrix3d across(const Eigen::Vector3d& omega) {
  return omega.squaredNorm() * Matrix3d::Identity() - omega * omega.transpose();
}

VectorXd components(const Matrix3d& symmetric) {
  return VectorXd{{symmetric(0, 0), symmetric(1, 1), symmetric(2, 2),
                   std::sqrt(2.0) * symmetric(0, 1),
                   std::sqrt(2.0) * symmetric(0, 2),
                   std::sqrt(2.0) * symmetric(1, 2)}};
}
Matrix3d of_components(const VectorXd& c) {
  const double half = std::sqrt(0.5);
  return Matrix3d{{c[0], half * c[3], half * c[4]},
                  {half * c[3], c[1], half * c[5]},
                  {half * c[4], half * c[5], c[2]}};
}

/// A symmetric matrix of nodes' components on forces, dofs × columns.
MatrixXd turned(const Matrix3d& turns, MatrixXd forces) {
  for (Index column = 0; column < forces.cols(); ++column) {
    for (Index row = 0; row < forces.rows(); row += 3) {
      forces.col(column).segment<3>(row) =
          turns * forces.col(column).segment<3>(row).eval();
    }
  }
  return forces;
}

}  // namespace

SecondOrderSolver::SecondOrderSolver(const StressedPart& part, std::size_t hold)
    : part_(part),
      hold_(hold),
      basis_(part.part().answer(part.pushes().unit_forces(), hold)),
      displaced_(part.displaced().rows(), 0),
      motions_(part.pushes().motions(displaced_)) {
  append(part.part().freed(part.loaded(), hold));
}

std::optional<VectorXd> SecondOrderSolver::lacking(bool is_spin,
                                                   const VectorXd& what) const {
  constexpr double kNothing = 1e-7;
  VectorXd rest = what;
  for (int pass = 0; pass < 2; ++pass) {
    for (const Term& term : terms_) {
      if (term.is_spin != is_spin) continue;
      rest -= term.direction.dot(rest) * term.direction;
    }
  }
  if (rest.norm() <= kNothing * what.norm()) return std::nullopt;
  return rest.normalized();
}

void SecondOrderSolver::add_amounts(bool is_spin, const VectorXd& what,
                                    VectorXd& amounts) const {
  for (std::size_t k = 0; k < terms_.size(); ++k) {
    if (terms_[k].is_spin != is_spin) continue;
    amounts[static_cast<Index>(k)] += terms_[k].direction.dot(what);
  }
}

SecondOrderSolver::Action SecondOrderSolver::action(const Loads& loads) {
  const HeldPart& held = part_.part();
  if (const auto lacks = lacking(false, loads.stressing)) {
    append({.is_spin = false,
            .direction = *lacks,
            .matrix = std::make_shared<MassMatrix>(
                part_.stress().stiffness(held.pairs(), *lacks)),
            .turns = -Matrix3d::Identity()});
  }
  const VectorXd spin = components(across(loads.omega));
  if (const auto lacks = lacking(true, spin)) {
    const auto known = std::ranges::find(terms_, true, &Term::is_spin);
    append({.is_spin = true,
            .direction = *lacks,
            .matrix = known == terms_.end()
                          ? std::make_shared<MassMatrix>(held.mass())
                          : known->matrix,
            .turns = of_components(*lacks)});
  }
  Action action{VectorXd::Zero(std::ssize(terms_)), loads.gain};
  add_amounts(false, loads.stressing, action.terms);
  add_amounts(true, spin, action.terms);
  return action;
}

SecondOrderSolver::Action SecondOrderSolver::without_spin(Action action) const {
  for (std::size_t k = 0; k < terms_.size(); ++k) {
    if (terms_[k].is_spin) action.terms[static_cast<Index>(k)] = 0.0;
  }
  return action;
}

void SecondOrderSolver::append(Term term) {
  if (!basis_.has_room(basis_.size())) {  // it starts anew
    basis_.clear();
    displaced_.resize(Eigen::NoChange, 0);
    motions_.resize(Eigen::NoChange, 0);
  }
  basis_.append_term(image(term, displaced_));
  terms_.push_back(std::move(term));
}

MatrixXd SecondOrderSolver::image(const Term& term, const MatrixXd& u) const {
  return part_.part().answer(turned(term.turns, multiply(*term.matrix, u)),
                             hold_);
}

void SecondOrderSolver::append(const MatrixXd& unknowns) {
  const MatrixXd vectors = basis_.beside(unknowns);
  if (vectors.cols() == 0) return;
  const MatrixXd u = part_.part().displacements(vectors, hold_);
  std::vector<MatrixXd> images;
  for (const Term& term : terms_) images.push_back(image(term, u));
  basis_.append(vectors, images);
  displaced_.conservativeResize(u.rows(), basis_.size());
  displaced_.rightCols(u.cols()) = u;
  motions_ = part_.pushes().motions(displaced_);
}

std::function<VectorXd(const VectorXd&)> SecondOrderSolver::answer_to(
    const Action& action) const {
  const NodePairs& pairs = part_.part().pairs();
  MassMatrix geometric{pairs.row_start, pairs.column,
                       std::vector<double>(pairs.column.size(), 0.0)};
  std::shared_ptr<const MassMatrix> mass;
  Matrix3d spin = Matrix3d::Zero();
  for (std::size_t k = 0; k < terms_.size(); ++k) {
    const double amount = action.terms[static_cast<Index>(k)];
    if (terms_[k].is_spin) {
      mass = terms_[k].matrix;
      spin += amount * terms_[k].turns;
      continue;
    }
    for (std::size_t i = 0; i < geometric.value.size(); ++i) {
      geometric.value[i] += amount * terms_[k].matrix->value[i];
    }
  }
  return [this, geometric = std::move(geometric), mass, spin,
          &gain = action.gain](const VectorXd& y) -> VectorXd {
    const HeldPart& held = part_.part();
    const MatrixXd u = held.displacements(y, hold_);
    MatrixXd forces = -multiply(geometric, u);
    part_.pushes().add(u, gain, forces);
    if (!spin.isZero(0.0)) forces += turned(spin, multiply(*mass, u));
    return held.answer(forces, hold_);
  };
}

State SecondOrderSolver::add(const Action& action, const VectorXd& load,
                             VectorXd& displacement) {
  constexpr double kTolerance = 1e-4;  // of the residual
  const HeldPart& held = part_.part();
  // What the loads strain against a hold beyond six conditions stays.
  const VectorXd free = held.freed(load, hold_), stays = load - free;
  const bool all_free = stays.isZero(0.0);
  const VectorXd b = all_free ? free : free + answer_to(action)(stays);
  if (!all_free) displacement += held.displacements(stays, hold_);
  const double wanted = kTolerance * b.norm();
  const ReducedBasis::Action reduced{action.terms, action.gain * motions_};
  const auto solution = basis_.solve(reduced, b);
  if (!solution.is_stable) return State::kUnstable;
  displacement += displaced_ * solution.amounts;
  if (solution.residual <= wanted) return State::kStable;
  VectorXd further;
  const State state =
      solve(answer_to(action), basis_.residual(reduced, b, solution.amounts),
            wanted, further);
  displacement += held.displacements(further, hold_);
  if (state == State::kStable) append(further);
  return state;
}

SecondOrderSolver::Answer SecondOrderSolver::answer(const Loads& loads) {
  const HeldPart& held = part_.part();
  const Action action = this->action(loads);
  Answer result;
  result.displacement = VectorXd::Zero(displaced_.rows());
  result.state = add(action, part_.loaded() * loads.spun, result.displacement);
  if (result.state == State::kStable && !loads.still.isZero()) {
    result.state = add(without_spin(action), part_.loaded() * loads.still,
                       result.displacement);
  }
  // A shape that the loads do not excite may have no stiffness left, too.
  if (!loads.omega.isZero() && result.state == State::kStable) {
    const VectorXd random = dynamics::random_block(held.equations(), 1);
    append(held.freed(random, hold_));
    VectorXd displacement = VectorXd::Zero(displaced_.rows());
    result.state = add(action, random, displacement);
  }
  return result;
}

}  // namespace clevis::elasticity
