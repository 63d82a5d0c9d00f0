#include "elasticity/vibration/seat_shapes.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <utility>

#include <Eigen/Eigenvalues>

#include "base/algebra/append_columns.h"
#include "base/algebra/singular_vectors.h"
#include "base/algebra/unit_columns.h"
#include "dynamics/systems/block_krylov.h"
#include "elasticity/algebra/dense_product.h"
#include "elasticity/algebra/principal_columns.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kRoundOff = 1e-9;  // of rows of like size

/// K-orthonormal columns of the span; what is round-off of others is left out.
/// In their energy local shapes are not small beside those of all the part.
MatrixXd orthonormal_in(const MatrixXd& columns, const MatrixXd& weighted) {
  constexpr double kLeast = 1e-8;  // of a column's square
  return product(columns, orthonormal_combinations(
                              transposed_product(columns, weighted), kLeast));
}

/// M-orthonormal columns of a span in which K is diagonal.
struct OwnShapes {
  /// @param columns  nearly K-orthonormal.
  OwnShapes(const MatrixXd& columns, const dynamics::LinearSystem& system) {
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> own(
        transposed_product(columns, system.mass(columns)),
        transposed_product(columns, system.stiffness(columns)));
    const VectorXd masses = own.eigenvalues();  // of shapes of unit stiffness
    squares = masses.cwiseInverse();
    shapes =
        product(columns, own.eigenvectors() * squares.cwiseSqrt().asDiagonal());
  }

  MatrixXd shapes;
  VectorXd squares;  ///< [1/s²]
};

/// Of dampers D Dᵀ in vibrations of mass one [1]. @param dampers  Dᵀ.
VectorXd ratios_of(const MatrixXd& dampers, const MatrixXd& shapes,
                   const VectorXd& squares) {
  const VectorXd lost = (dampers * shapes).colwise().squaredNorm();
  return 0.5 * lost.cwiseQuotient(squares.cwiseSqrt());
}

}  // namespace

SeatShapes::SeatShapes(const VibratingPart<3>& part, MatrixXd seats,
                       const MatrixXd& means, bool has_fields)
    : seats_(std::move(seats)) {
  const dynamics::LinearSystem& system = part.free;
  const MatrixXd forces = restrict_rows(product(means, seats_), part.numbers);
  const MatrixXd rigid = dynamics::mass_orthonormal(system, system.rigid);
  const MatrixXd weighted = system.mass(rigid);
  const auto elastic = [&](const MatrixXd& x) -> MatrixXd {
    return x - product(rigid, transposed_product(weighted, x));
  };
  const auto solve = system.factor(system.least_shift());
  const auto own_shapes = [&](MatrixXd columns) {
    for (int pass = 0; pass < 2; ++pass) {
      columns = elastic(orthonormal_in(columns, system.stiffness(columns)));
    }
    return OwnShapes(columns, system);
  };
  // Of those at rest their own: what is kept beside them hangs on no basis of
  // the wrenches then.
  const MatrixXd at_rest = own_shapes(elastic(solve(forces))).shapes;
  MatrixXd both(at_rest.rows(), 2 * at_rest.cols());
  both << at_rest, elastic(solve(system.mass(at_rest)));
  const OwnShapes own = own_shapes(std::move(both));
  MatrixXd shapes(own.shapes.rows(), rigid.cols() + own.shapes.cols());
  shapes << rigid, own.shapes;
  rigid_ = rigid.cols();
  motions_ = transposed_product(forces, shapes);
  squares_ = VectorXd::Zero(shapes.cols());
  squares_.tail(own.squares.size()) = own.squares;
  if (!has_fields) return;
  fields_.emplace();
  fields_->discretization = part.discretization;
  fields_->columns = extend_rows(shapes, part.numbers);
}

MatrixXd SeatShapes::along_shapes(const MatrixXd& wrenches) const {
  return along_seats(wrenches).transpose() * motions_;
}

MatrixXd SeatShapes::along_seats(const MatrixXd& wrenches) const {
  return seats_.transpose() * wrenches;
}

/// Of a span of shapes what a hold leaves, and how it moves.
struct SeatShapes::Held {
  MatrixXd left;  ///< of the shapes
  MatrixXd stiffness, mass;
  MatrixXd dampers;  ///< D of D Dᵀ, transposed
  Index free{};      ///< rigid motions that neither holds nor springs feel
};

SeatShapes::Held SeatShapes::held(const loads::SeatHold& hold,
                                  Index shapes) const {
  // Of shapes and, behind them, motions of other bodies that springs swing.
  const Index bodies = hold.swinging ? hold.swinging->followed.rows() : 0;
  const Index all = shapes + bodies;
  const auto rows_of = [&](const MatrixXd& wrenches,
                           const MatrixXd& there) -> MatrixXd {
    MatrixXd rows(wrenches.cols(), all);
    rows.leftCols(shapes) =
        along_seats(wrenches).transpose() * motions_.leftCols(shapes);
    if (bodies > 0) rows.rightCols(bodies) = there.transpose();
    return rows;
  };
  std::vector<Index> rigid_ones(static_cast<std::size_t>(rigid_ + bodies));
  std::iota(rigid_ones.begin(), rigid_ones.begin() + rigid_, Index{0});
  std::iota(rigid_ones.begin() + rigid_, rigid_ones.end(), shapes);
  Held found;
  found.left = MatrixXd::Identity(all, all);
  MatrixXd loose = MatrixXd::Identity(rigid_ + bodies, rigid_ + bodies);
  const auto take = [&](const MatrixXd& rows) {
    if (rows.rows() == 0 || loose.cols() == 0) return;
    loose *= null_space(rows(Eigen::all, rigid_ones) * loose, kRoundOff);
  };
  const MatrixXd constraints =
      hold.swinging ? rows_of(hold.swinging->held, hold.swinging->followed)
                    : rows_of(unit_columns(hold.held), {});
  if (constraints.rows() > 0) {
    found.left = null_space(constraints, kRoundOff);
    take(constraints);
  }
  MatrixXd mass = MatrixXd::Identity(all, all);
  MatrixXd stiffness = MatrixXd::Zero(all, all);
  stiffness.diagonal().head(shapes) = squares_.head(shapes);
  MatrixXd springs(0, all), dampers(0, all);
  if (hold.swinging) {
    springs = rows_of(hold.swinging->sprung, hold.swinging->sprung_there);
    dampers = rows_of(hold.swinging->damped, hold.swinging->damped_there);
  } else {
    const MatrixXd added = rows_of(hold.weighed, {});
    mass += added.transpose() * added;
    if (hold.sprung.cols() > 0) springs = rows_of(hold.sprung, {});
    if (hold.damped.cols() > 0) dampers = rows_of(hold.damped, {});
  }
  stiffness += springs.transpose() * springs;
  take(springs);
  found.free = loose.cols();
  found.stiffness = found.left.transpose() * stiffness * found.left;
  found.mass = found.left.transpose() * mass * found.left;
  found.dampers = dampers * found.left;
  return found;
}

SeatShapes::Vibrations SeatShapes::held_by(const loads::SeatHold& hold) const {
  const Held all = held(hold, squares_.size());
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> modes(all.stiffness,
                                                                 all.mass);
  const Index count = all.left.cols() - all.free;
  const VectorXd squares = modes.eigenvalues().tail(count);
  const MatrixXd vibrations = modes.eigenvectors().rightCols(count);
  const MatrixXd shapes = all.left.topRows(motions_.cols()) * vibrations;
  const Index elastic = motions_.cols() - rigid_;
  const MatrixXd bent = shapes.bottomRows(elastic);
  const VectorXd own = bent.cwiseAbs2().transpose() * squares_.tail(elastic);
  return {squares, ratios_of(all.dampers, vibrations, squares),
          motions_ * shapes, motions_.rightCols(elastic) * bent,
          own.cwiseQuotient(squares).cwiseMin(1.0)};
}

SeatShapes::Swings SeatShapes::rigid_swings(const loads::SeatHold& hold) const {
  const Held rigid = held(hold, rigid_);
  const Index count = rigid.left.cols() - rigid.free;
  if (count == 0) return {};
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> modes(
      rigid.stiffness, rigid.mass);
  const VectorXd squares = modes.eigenvalues().tail(count);
  return {squares, ratios_of(rigid.dampers,
                             modes.eigenvectors().rightCols(count), squares)};
}

std::vector<SeatShapes::Moved> SeatShapes::moved_by_spin(
    const loads::SeatHold& hold) const {
  constexpr Index kMost = 6, kShapes = 24;
  const Vibrations still = held_by(hold);
  const Index count = std::min(kShapes, still.squares.size());
  const MatrixXd motions = still.motions.leftCols(count);
  const MatrixXd spin = seats_.transpose() * hold.spin * seats_;
  const VectorXd own = still.squares.head(count).cwiseSqrt();
  // Of speeds, and of shapes times their own frequency: [[−S, −ω], [ω, 0]] is
  // skew, its eigenvalues are ±i times the moved frequencies.
  MatrixXd state = MatrixXd::Zero(2 * count, 2 * count);
  state.topLeftCorner(count, count) = -motions.transpose() * spin * motions;
  state.topRightCorner(count, count).diagonal() = -own;
  state.bottomLeftCorner(count, count).diagonal() = own;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd> solver(
      std::complex<double>(0.0, 1.0) * state);
  std::vector<Moved> found;
  for (Index k = 0; k < std::min(kMost, count); ++k) {
    // Of the shape that has most of its speeds: others may lie in between.
    Index from = 0;
    solver.eigenvectors().col(count + k).head(count).cwiseAbs2().maxCoeff(
        &from);
    found.push_back({own[from], solver.eigenvalues()[count + k]});
  }
  std::ranges::sort(found, {}, &Moved::still);
  return found;
}

MatrixXd span_of(const std::vector<loads::SeatHold>& holds,
                 const MatrixXd& loads) {
  constexpr double kLeast = 1e-12;  // of a column's square
  constexpr double kClear = 1e-4;   // likewise: less is round-off of holds
  MatrixXd all(holds.front().held.rows(), 0);
  for (const loads::SeatHold& hold : holds) {
    std::vector<const MatrixXd*> some = {&hold.held, &hold.weighed,
                                         &hold.sprung, &hold.damped};
    if (hold.swinging) {
      some.push_back(&hold.swinging->held);
      some.push_back(&hold.swinging->sprung);
      some.push_back(&hold.swinging->damped);
    }
    for (const MatrixXd* wrenches : some) {
      const MatrixXd more = unit_columns(*wrenches);
      if (more.cols() > 0) append_columns(more, all);
    }
  }
  MatrixXd span(all.rows(), 0);
  if (all.cols() > 0) {
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(all * all.transpose());
    const VectorXd& values = solver.eigenvalues();
    const Index kept = (values.array() > kLeast * values.maxCoeff()).count();
    span = solver.eigenvectors().rightCols(kept);
  }
  if (loads.cols() > 0) {
    MatrixXd beyond = unit_columns(loads);
    beyond -= span * (span.transpose() * beyond);
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(beyond *
                                                         beyond.transpose());
    const Index kept = (solver.eigenvalues().array() > kClear).count();
    append_columns(solver.eigenvectors().rightCols(kept), span);
  }
  return span;
}

}  // namespace clevis::elasticity
