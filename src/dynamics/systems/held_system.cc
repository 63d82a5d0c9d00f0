#include "dynamics/systems/held_system.h"

#include <Eigen/QR>

#include "base/algebra/singular_vectors.h"
#include "base/algebra/unit_columns.h"
#include "dynamics/systems/block_krylov.h"

namespace clevis::dynamics {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// Of the largest: motions that constraints hold by less are free.
constexpr double kFree = 1e-9;

/// (K + s M)⁻¹ in the space that constraints leave. The rigid motions in
/// (K + s M)⁻¹, as large as 1/s, are unknowns of their own beside the
/// multipliers: what redundant constraints ask of the elastic part would be
/// round-off of them.
BlockOperator constrained(const LinearSystem& free, double shift,
                          const MatrixXd& c, const MatrixXd& rigid) {
  const BlockOperator elastic =
      [solve = free.factor(shift), rigid,
       weighted = free.mass(rigid)](const MatrixXd& b) -> MatrixXd {
    const MatrixXd x = solve(b - weighted * (rigid.transpose() * b));
    return x - rigid * (weighted.transpose() * x);
  };
  const MatrixXd answers = elastic(c);
  const MatrixXd moved = c.transpose() * rigid;
  const MatrixXd give = c.transpose() * answers;
  const double unit = give.diagonal().mean();
  const Index held = c.cols(), all = held + rigid.cols();
  MatrixXd balance(all, all);
  balance << give / unit, -moved, moved.transpose(),
      shift * unit * MatrixXd::Identity(rigid.cols(), rigid.cols());
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> between;
  between.setThreshold(kFree);
  between.compute(balance);
  return [elastic, answers, between, c, rigid, unit,
          held](const MatrixXd& b) -> MatrixXd {
    const MatrixXd x = elastic(b);
    MatrixXd asked(held + rigid.cols(), b.cols());
    asked << c.transpose() * x, unit * (rigid.transpose() * b);
    const MatrixXd found = between.solve(asked);
    return x - answers * (found.topRows(held) / unit) +
           rigid * found.bottomRows(rigid.cols());
  };
}

}  // namespace

LinearSystem held_system(const LinearSystem& free,
                         const MatrixXd& constraints) {
  const MatrixXd c = unit_columns(constraints);
  LinearSystem system = free;
  system.is_held = true;
  const MatrixXd rigid = mass_orthonormal(free, free.rigid);
  system.rigid = rigid * null_space(c.transpose() * rigid, kFree);
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> own;
  own.setThreshold(kFree);
  own.compute(c.transpose() * c);
  system.admitted = [own, c](const MatrixXd& x) -> MatrixXd {
    return x - c * own.solve(c.transpose() * x);
  };
  system.factor = [free, c, rigid](double shift) {
    return constrained(free, shift, c, rigid);
  };
  return system;
}

MatrixXd moved_to_constraints(const LinearSystem& free,
                              const MatrixXd& constraints,
                              const MatrixXd& columns) {
  const MatrixXd c = unit_columns(constraints);
  const MatrixXd rigid = mass_orthonormal(free, free.rigid);
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> held;
  held.setThreshold(kFree);
  held.compute(c.transpose() * rigid);
  return columns - rigid * held.solve(c.transpose() * columns);
}

}  // namespace clevis::dynamics
