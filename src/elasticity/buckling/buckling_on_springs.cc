#include "elasticity/buckling/buckling_on_springs.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include "elasticity/algebra/dense_product.h"
#include "elasticity/nodal_loads/seat_means.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kRoundOff = 1e-9;

/// What the rows of a matrix leave, orthonormal.
MatrixXd left_by(const MatrixXd& rows) {
  if (rows.rows() == 0) return MatrixXd::Identity(rows.cols(), rows.cols());
  Eigen::JacobiSVD<MatrixXd> svd(rows, Eigen::ComputeFullV);
  svd.setThreshold(kRoundOff);
  return svd.matrixV().rightCols(rows.cols() - svd.rank());
}

/// Rows of held conditions on motions of the seats.
MatrixXd conditions(const loads::SeatHold& hold, const MatrixXd& motions) {
  if (hold.held.cols() == 0) return MatrixXd(0, motions.cols());
  return hold.held.colwise().normalized().transpose() * motions;
}

/// Combinations with an energy of 1 each; those without energy are left out,
/// not those that are soft beside others.
MatrixXd of_unit_energy(const MatrixXd& energy) {
  constexpr double kNone = 1e-12;
  const VectorXd scale = energy.diagonal().unaryExpr([](double e) {
    return e > 0.0 ? 1.0 / std::sqrt(e) : 0.0;
  });
  const Eigen::SelfAdjointEigenSolver<MatrixXd> found(
      scale.asDiagonal() * energy * scale.asDiagonal());
  const VectorXd& values = found.eigenvalues();
  const Index kept = (values.array() > kNone * values.maxCoeff()).count();
  return scale.asDiagonal() * found.eigenvectors().rightCols(kept) *
         values.tail(kept).cwiseSqrt().cwiseInverse().asDiagonal();
}

/// Unknowns of the same span, orthonormal, without what is dependent.
MatrixXd orthonormal(const MatrixXd& unknowns) {
  constexpr double kDependent = 1e-9;
  const VectorXd scale = unknowns.colwise().norm().unaryExpr([](double size) {
    return size > 0.0 ? 1.0 / size : 0.0;
  });
  const Eigen::SelfAdjointEigenSolver<MatrixXd> gram(
      scale.asDiagonal() * transposed_product(unknowns, unknowns) *
      scale.asDiagonal());
  const VectorXd& values = gram.eigenvalues();
  const Index kept = (values.array() > kDependent).count();
  return product(unknowns,
                 scale.asDiagonal() * gram.eigenvectors().rightCols(kept) *
                     values.tail(kept).cwiseSqrt().cwiseInverse().asDiagonal());
}

}  // namespace

BucklingOnSprings::BucklingOnSprings(const BucklingProblem& problem,
                                     const StressedPart& stressed)
    : history_(problem.history), stressed_(stressed) {
  constexpr std::size_t kMost = 65;
  const HeldPart& part = stressed.part();
  const std::size_t all = history_.instants.size();
  if (!history_.hold || !part.is_free()) return;
  const std::size_t count = std::min(kMost, all);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = count == 1 ? 0 : k * (all - 1) / (count - 1);
    if (hold_at(static_cast<Index>(i)).sprung.cols() == 0) continue;
    instants_.push_back(static_cast<Index>(i));
  }
  if (instants_.empty()) return;
  means_ = seat_means(problem.discretization, history_.seats, {}, problem.name);
  rigid_ = part.rigid();
}

loads::SeatHold BucklingOnSprings::hold_at(Index instant) const {
  return history_.hold(
      history_.instants[static_cast<std::size_t>(instant)].time);
}

double BucklingOnSprings::of_rigid(Index instant, const MatrixXd& form) const {
  const loads::SeatHold hold = hold_at(instant);
  const MatrixXd motions = transposed_product(means_, rigid_);
  const MatrixXd left = left_by(conditions(hold, motions));
  if (left.cols() == 0) return 0.0;
  const MatrixXd springs = hold.sprung.transpose() * motions * left;
  if (springs.isZero(0.0)) return 0.0;
  const MatrixXd unit = left * of_unit_energy(springs.transpose() * springs);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> pushed(
      unit.transpose() * form * unit, Eigen::EigenvaluesOnly);
  return std::max(0.0, pushed.eigenvalues().maxCoeff());
}

/// One space of rigid motions and shapes.
class BucklingOnSprings::Ritz {
 public:
  /// @param forces  F u [N] of displacements u, dofs × columns.
  template <typename Forces>
  Ritz(const BucklingOnSprings& of, const loads::SeatHold& hold,
       const MatrixXd& unknowns, const Forces& forces) {
    const Index rigid = of.rigid_.cols();
    const MatrixXd bent =
        of.stressed_.part().displacements(orthonormal(unknowns), 0);
    MatrixXd shapes(bent.rows(), rigid + bent.cols());
    shapes << of.rigid_, bent;
    MatrixXd motions = transposed_product(of.means_, shapes);
    // Bent by 1 √J the seats move far less than by a rigid motion of 1.
    const double scale =
        motions.leftCols(rigid).cwiseAbs().maxCoeff() /
        std::max(motions.rightCols(bent.cols()).cwiseAbs().maxCoeff(), 1e-300);
    shapes.rightCols(bent.cols()) *= scale;
    motions.rightCols(bent.cols()) *= scale;
    const MatrixXd left = left_by(conditions(hold, motions));
    const MatrixXd springs = hold.sprung.transpose() * motions * left;
    const MatrixXd strained = scale * left.bottomRows(bent.cols());
    Eigen::JacobiSVD<MatrixXd> by_springs(springs);
    by_springs.setThreshold(kRoundOff);
    const MatrixXd unit =
        left * of_unit_energy(strained.transpose() * strained +
                              springs.transpose() * springs);
    const Index conditions = shapes.cols() - left.cols() + by_springs.rank();
    is_determinate_ = conditions == rigid && unit.cols() == left.cols();
    const MatrixXd form = transposed_product(shapes, forces(shapes));
    const Eigen::SelfAdjointEigenSolver<MatrixXd> pushed(
        unit.transpose() * (0.5 * (form + form.transpose())) * unit);
    constexpr Index kShapes = 2;
    const Index n = std::min(kShapes, unit.cols());
    yield_ = pushed.eigenvalues().maxCoeff();
    shapes_ = product(shapes, unit * pushed.eigenvectors().rightCols(n));
  }

  double yield() const { return yield_; }             ///< largest 1/λ [1]
  const MatrixXd& shapes() const { return shapes_; }  ///< of the largest few
  /// Nothing is held twice, and nothing moves freely.
  bool is_determinate() const { return is_determinate_; }

 private:
  double yield_{};
  MatrixXd shapes_;
  bool is_determinate_ = false;
};

BucklingOnSprings::Together BucklingOnSprings::together(
    Index instant, const MatrixXd& start) const {
  constexpr int kMostSteps = 12;
  constexpr double kSettled = 1e-4;
  const HeldPart& part = stressed_.part();
  const MassMatrix geometric = stressed_.stress().stiffness(
      part.pairs(), stressed_.coefficients().col(instant));
  const MatrixXd gain = stressed_.pushes().gain(instant);
  const auto forces = [&](const MatrixXd& u) {
    MatrixXd pushing = -multiply(geometric, u);
    stressed_.pushes().add(u, gain, pushing);
    return pushing;
  };
  const loads::SeatHold hold = hold_at(instant);
  MatrixXd unknowns = part.answer_in_balance(means_, 0);
  const auto add = [&](const MatrixXd& more) {
    unknowns.conservativeResize(Eigen::NoChange, unknowns.cols() + more.cols());
    unknowns.rightCols(more.cols()) = more;
  };
  add(start);
  double before = 0.0;
  for (int step = 0;; ++step) {
    const Ritz ritz(*this, hold, unknowns, forces);
    const bool settled =
        step > 0 && std::abs(ritz.yield() - before) < kSettled * before;
    if (settled || step == kMostSteps) {
      return {std::max(0.0, ritz.yield()), ritz.is_determinate()};
    }
    before = ritz.yield();
    add(part.answer_in_balance(forces(ritz.shapes()), 0));
  }
}

}  // namespace clevis::elasticity
