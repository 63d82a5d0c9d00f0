#include "mechanism/equations_of_motion/sticking_shares.h"

#include <algorithm>

#include <Eigen/QR>

namespace clevis::mechanism {
namespace {

// Part of a combination of rows above which a row takes part in it.
constexpr double kTakesPart = 1e-6;

}  // namespace

void share_among_sticking(const MotionConstraints& constraints,
                          const ForceModel& forces, const ForceState& acting,
                          Eigen::VectorXd& multipliers) {
  const Eigen::Index rows = constraints.rows();
  Eigen::VectorXd weight = Eigen::VectorXd::Zero(rows);
  bool any = false;
  constraints.for_each_element_row([&](std::size_t k, int row) {
    const ActingElement& e = forces.element(k);
    const double most = e.sticks() ? e.breakaway(acting.elements[k]) : 0.0;
    if (!(most > 0.0)) return;
    weight[row] = constraints.row_scale(k) / most;
    any = true;
  });
  if (!any) return;
  const Eigen::MatrixXd free = constraints.open_multipliers();
  if (free.cols() == 0) return;
  const Eigen::VectorXd ratio = weight.cwiseProduct(multipliers.head(rows));
  const Eigen::MatrixXd shares = weight.asDiagonal() * free;
  // combinations of joints' rows alone, which are redundant, have no part
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> sharing(
      shares.rows(), shares.cols());
  sharing.setThreshold(kTakesPart * weight.maxCoeff() /
                       std::max(shares.norm(), 1e-300));
  sharing.compute(shares);
  multipliers.head(rows) -= free * sharing.solve(ratio);
}

}  // namespace clevis::mechanism
