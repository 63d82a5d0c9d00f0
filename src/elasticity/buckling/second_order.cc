#include "elasticity/buckling/second_order.h"

#include <algorithm>
#include <cmath>
#include <functional>

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

using State = SecondOrderPart::State;

/// Solves y − A y = b by conjugate gradients: unstable where 1 is no bound of
/// A's eigenvalues.
State solve(const std::function<VectorXd(const VectorXd&)>& a,
            const VectorXd& b, VectorXd& y) {
  constexpr int kMostSteps = 300;
  constexpr double kTolerance = 1e-4;
  y = VectorXd::Zero(b.size());
  VectorXd residual = b, direction = b;
  double square = residual.squaredNorm();
  const double wanted = kTolerance * kTolerance * square;
  for (int step = 0; step < kMostSteps && square > wanted; ++step) {
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
  return square <= wanted ? State::kStable : State::kOpen;
}

}  // namespace

SecondOrderPart::Answer SecondOrderPart::answer(const Loads& loads,
                                                std::size_t hold) const {
  const MassMatrix geometric =
      stressed_.stress().stiffness(part_.pairs(), loads.stressing);
  const bool spins = !loads.omega.isZero();
  const MassMatrix mass = spins ? part_.mass() : MassMatrix{};
  const auto yields = [&](const VectorXd& y, bool with_spin) -> VectorXd {
    const MatrixXd u = part_.displacements(y, hold);
    MatrixXd forces = -multiply(geometric, u);
    stressed_.pushes().add(u, loads.gain, forces);
    if (with_spin) forces += spin_forces(mass, loads.omega, u);
    return part_.answer(forces, hold);
  };
  VectorXd sum = VectorXd::Zero(part_.equations());
  const auto add = [&](const VectorXd& load, bool with_spin) {
    // What the loads strain against a hold beyond six conditions stays.
    const VectorXd free = part_.freed(load, hold), stays = load - free;
    VectorXd unknowns;
    const State state = solve(
        [&](const VectorXd& y) {
          return yields(y, with_spin);
        },
        stays.isZero(0.0) ? free : free + yields(stays, with_spin), unknowns);
    sum += stays + unknowns;
    return state;
  };
  Answer result;
  result.state = add(stressed_.loaded() * loads.spun, spins);
  if (result.state == State::kStable && !loads.still.isZero()) {
    result.state = add(stressed_.loaded() * loads.still, false);
  }
  result.displacement = part_.displacements(sum, hold);
  // A shape that the loads do not excite may have no stiffness left, too.
  if (spins && result.state == State::kStable) {
    result.state = add(dynamics::random_block(part_.equations(), 1), true);
  }
  return result;
}

}  // namespace clevis::elasticity
