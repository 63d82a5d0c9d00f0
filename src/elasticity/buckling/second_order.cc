#include "elasticity/buckling/second_order.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Ω² M u less what points along the axis of spin: forces on the nodes.
MatrixXd spin_forces(const MassMatrix& mass, const Eigen::Vector3d& omega,
                     const MatrixXd& u) {
  const Eigen::Matrix3d across =
      omega.squaredNorm() * Eigen::Matrix3d::Identity() -
      omega * omega.transpose();
  MatrixXd forces = multiply(mass, u);
  for (Index column = 0; column < forces.cols(); ++column) {
    for (Index row = 0; row < forces.rows(); row += 3) {
      forces.col(column).segment<3>(row) =
          across * forces.col(column).segment<3>(row).eval();
    }
  }
  return forces;
}

/// Solves y − A y = b by conjugate gradients.
/// @return whether it did; not where 1 is no bound of A's eigenvalues.
bool solve(const std::function<VectorXd(const VectorXd&)>& a, const VectorXd& b,
           VectorXd& y) {
  constexpr int kMostSteps = 100;
  constexpr double kTolerance = 1e-4;
  y = VectorXd::Zero(b.size());
  VectorXd residual = b, direction = b;
  double square = residual.squaredNorm();
  const double wanted = kTolerance * kTolerance * square;
  for (int step = 0; step < kMostSteps && square > wanted; ++step) {
    const VectorXd product = direction - a(direction);
    const double curvature = direction.dot(product);
    if (!(curvature > 0.0)) return false;
    const double length = square / curvature;
    y += length * direction;
    residual -= length * product;
    const double before = square;
    square = residual.squaredNorm();
    direction = residual + square / before * direction;
  }
  return !(square > wanted);
}

/// The same on every run and platform, none of whose shares of a shape is zero.
VectorXd anything(Index rows, Index seed) {
  std::mt19937 random(static_cast<unsigned>(seed) + 1U);
  VectorXd result(rows);
  for (double& entry : result) {
    entry = static_cast<double>(random()) / 4294967296.0 - 0.5;
  }
  return result;
}

}  // namespace

double SecondOrderPart::lowest_frequency(std::size_t hold) const {
  constexpr int kSteps = 6;
  constexpr Index kBlock = 4;
  const MassMatrix mass =
      part_.stress().mass(part_.pairs(), problem_.material.density);
  MatrixXd start(part_.equations(), std::min(kBlock, part_.equations()));
  for (Index k = 0; k < start.cols(); ++k) {
    start.col(k) = anything(part_.equations(), k);
  }
  dynamics::BlockKrylov space(part_.answer_to(mass, 1.0, hold), start, {});
  for (int step = 0; step < kSteps && !space.is_closed(); ++step) {
    space.extend();
  }
  return 1.0 / std::sqrt(space.ritz_values().theta[0]);
}

SecondOrderPart::Answer SecondOrderPart::answer(const Loads& loads,
                                                std::size_t hold) const {
  const MassMatrix geometric =
      part_.stress().stiffness(part_.pairs(), loads.acting);
  const bool spins = !loads.omega.isZero();
  const MassMatrix mass =
      spins ? part_.stress().mass(part_.pairs(), problem_.material.density)
            : MassMatrix{};
  const auto a = [&](const VectorXd& y) -> VectorXd {
    const MatrixXd u = part_.shapes(y, hold);
    MatrixXd forces = -multiply(geometric, u);
    if (spins) forces += spin_forces(mass, loads.omega, u);
    return part_.answer(forces, hold);
  };
  VectorXd unknowns, unused;
  Answer result;
  result.is_stable = solve(a, part_.loaded() * loads.acting, unknowns);
  // A shape that the loads do not excite may have no stiffness left, too.
  if (spins && result.is_stable) {
    result.is_stable = solve(a, anything(part_.equations(), 0), unused);
  }
  result.displacement =
      part_.shapes(unknowns + part_.loaded() * loads.others, hold);
  return result;
}

}  // namespace clevis::elasticity
