#include "dynamics/systems/eigenmodes.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/messages/errors.h"
#include "dynamics/systems/block_krylov.h"

namespace clevis::dynamics {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Wider than any eigenvalue of a symmetric part is multiple.
constexpr Index kBlock = 6;

void check(const LinearSystem& system, const BlockOperator& solve, double shift,
           const std::string& name, double tolerance, Modes& modes) {
  // Stiff cells leave round-off in the quotient of a soft mode: a block on a
  // neck a sixteenth as high 3e-7.
  constexpr double kRayleigh = 1e-5;
  // Of rough shapes it tells no more than how stiff the cells are.
  constexpr double kRough = 1e-6;
  const double most = 100.0 * tolerance;
  const double most_rayleigh = tolerance > kRough ? HUGE_VAL : kRayleigh;
  const MatrixXd weighted = system.mass(modes.shapes);
  const MatrixXd forces = system.stiffness(modes.shapes);
  const VectorXd shifted = modes.squares.array() + shift;
  const MatrixXd rest = solve(weighted) * shifted.asDiagonal() - modes.shapes;
  modes.residual = rest.cwiseProduct(system.mass(rest))
                       .colwise()
                       .sum()
                       .cwiseMax(0.0)
                       .cwiseSqrt()
                       .transpose();
  const VectorXd quotient =
      modes.shapes.cwiseProduct(forces).colwise().sum().transpose().array() /
      modes.shapes.cwiseProduct(weighted).colwise().sum().transpose().array();
  modes.rayleigh_error =
      (quotient - modes.squares).cwiseAbs().cwiseQuotient(shifted);
  if (modes.residual.maxCoeff() < most &&
      modes.rayleigh_error.maxCoeff() < most_rayleigh) {
    return;
  }
  throw Error(
      "F003", name,
      fmt::format("a mode does not satisfy its equation: residual "
                  "{:.2g}, Rayleigh quotient off by {:.2g}",
                  modes.residual.maxCoeff(), modes.rayleigh_error.maxCoeff()),
      "Mesh the part without slivers, or ask for fewer modes.");
}

}  // namespace

Modes lowest_modes(const LinearSystem& system, int count,
                   const std::string& name, double tolerance) {
  const MatrixXd rigid = mass_orthonormal(system, system.rigid);
  const double shift = system.least_shift();
  const BlockOperator solve = system.factor(shift);
  const Index wanted =
      std::min<Index>(std::max<Index>(count, rigid.cols()), system.size) -
      rigid.cols();
  Modes modes;
  modes.rigid = static_cast<int>(rigid.cols());
  MatrixXd elastic(system.size, 0);
  VectorXd theta(0);
  if (wanted > 0) {
    const Index width = std::min(kBlock, system.size - rigid.cols());
    BlockKrylov space(system, solve, random_block(system.size, width), rigid);
    for (;;) {
      space.extend();
      const auto ritz = space.ritz_values();
      const Index n = std::min(wanted, space.size());
      const bool settled =
          n == wanted && (ritz.residual.head(n).array() <
                          tolerance * ritz.theta.head(n).array())
                             .all();
      if (!settled && !space.is_closed()) continue;
      elastic = space.basis() * ritz.vectors.leftCols(n);
      theta = ritz.theta.head(n);
      modes.space = space.size();
      break;
    }
  }
  modes.shapes.resize(system.size, rigid.cols() + elastic.cols());
  modes.shapes << rigid, elastic;
  modes.squares = VectorXd::Zero(modes.shapes.cols());
  modes.squares.tail(theta.size()) = theta.cwiseInverse().array() - shift;
  check(system, solve, shift, name, tolerance, modes);
  return modes;
}

}  // namespace clevis::dynamics
