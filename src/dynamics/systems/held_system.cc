#include "dynamics/systems/held_system.h"

#include <Eigen/QR>
#include <Eigen/SVD>

#include "dynamics/systems/block_krylov.h"

namespace clevis::dynamics {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// Of the largest: motions that constraints hold by less are free.
constexpr double kFree = 1e-9;

/// Constraints of unit length.
MatrixXd normalised(const MatrixXd& constraints) {
  return constraints.colwise().normalized();
}

}  // namespace

LinearSystem held_system(const LinearSystem& free,
                         const MatrixXd& constraints) {
  const MatrixXd c = normalised(constraints);
  LinearSystem system = free;
  system.is_held = true;
  const MatrixXd rigid = mass_orthonormal(free, free.rigid);
  Eigen::JacobiSVD<MatrixXd> svd(c.transpose() * rigid, Eigen::ComputeFullV);
  svd.setThreshold(kFree);
  system.rigid = rigid * svd.matrixV().rightCols(rigid.cols() - svd.rank());
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> own;
  own.setThreshold(kFree);
  own.compute(c.transpose() * c);
  system.admitted = [own, c](const MatrixXd& x) -> MatrixXd {
    return x - c * own.solve(c.transpose() * x);
  };
  system.factor = [factor = free.factor, c](double shift) -> BlockOperator {
    const BlockOperator solve = factor(shift);
    const MatrixXd answers = solve(c);
    Eigen::CompleteOrthogonalDecomposition<MatrixXd> between;
    between.setThreshold(kFree);
    between.compute(c.transpose() * answers);
    return [solve, answers, between, c](const MatrixXd& b) -> MatrixXd {
      MatrixXd x = solve(b);
      // Twice: the rigid motions in A⁻¹ B are large beside what is left.
      for (int pass = 0; pass < 2; ++pass) {
        x -= answers * between.solve(c.transpose() * x);
      }
      return x;
    };
  };
  return system;
}

MatrixXd moved_to_constraints(const LinearSystem& free,
                              const MatrixXd& constraints,
                              const MatrixXd& columns) {
  const MatrixXd c = normalised(constraints);
  const MatrixXd rigid = mass_orthonormal(free, free.rigid);
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> held;
  held.setThreshold(kFree);
  held.compute(c.transpose() * rigid);
  return columns - rigid * held.solve(c.transpose() * columns);
}

}  // namespace clevis::dynamics
