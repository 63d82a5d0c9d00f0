#include "elasticity/buckling/second_order.h"

#include <functional>

#include "elasticity/buckling/stressed_part.h"

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

}  // namespace

std::vector<SecondOrder> second_order(const BucklingProblem& problem) {
  const StressedPart part(problem);
  std::vector<SecondOrder> all;
  if (part.coefficients().rows() == 0) return all;
  for (Index i = 0; i < part.instants(); ++i) {
    const Eigen::Vector3d omega =
        problem.history.instants[static_cast<std::size_t>(i)].rigid.omega;
    const MassMatrix geometric =
        part.stress().stiffness(part.pairs(), part.coefficients().col(i));
    const MassMatrix mass =
        omega.isZero()
            ? MassMatrix{}
            : part.stress().mass(part.pairs(), problem.material.density);
    const VectorXd linear = part.loaded(i);
    for (std::size_t hold = 0; hold < part.holds(); ++hold) {
      VectorXd unknowns;
      const bool is_stable = solve(
          [&](const VectorXd& y) -> VectorXd {
            const MatrixXd u = part.shapes(y, hold);
            MatrixXd forces = -multiply(geometric, u);
            if (!omega.isZero()) forces += spin_forces(mass, omega, u);
            return part.answer(forces, hold);
          },
          linear, unknowns);
      all.push_back({i, part.shapes(linear, hold), part.shapes(unknowns, hold),
                     is_stable});
    }
  }
  return all;
}

}  // namespace clevis::elasticity
