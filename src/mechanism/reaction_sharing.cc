#include "mechanism/reaction_sharing.h"

#include <cmath>
#include <cstddef>
#include <numbers>

#include <Eigen/QR>

namespace clevis::mechanism {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

Index joint_components(const SolvingFrame& frame) {
  return 6 * static_cast<Index>(frame.joints.size());
}

VectorXd compliances(const SolvingFrame& frame) {
  const Index joints = joint_components(frame);
  VectorXd c(joints + static_cast<Index>(frame.couplings.size()));
  for (std::size_t j = 0; j < frame.joints.size(); ++j) {
    c.segment<6>(6 * static_cast<Index>(j)) = frame.joints[j].compliance;
  }
  c.tail(c.size() - joints).setConstant(kDefaultCompliance);
  return c;
}

}  // namespace

MatrixXd components_of_rows(const SolvingFrame& frame,
                            const ConstraintSystem& system,
                            const std::vector<PlacedJoint>& placed) {
  const Index joints = joint_components(frame);
  MatrixXd E = MatrixXd::Zero(
      joints + static_cast<Index>(frame.couplings.size()), system.rows());
  for (int i = 0; i < system.joint_rows(); ++i) {
    const auto& row = system.row_list()[index(i)];
    if (row.coupling >= 0) {
      E(joints + row.coupling, i) = 1.0;
      continue;
    }
    const PlacedJoint& joint = placed[index(row.joint)];
    const Twist action = joint.action(row.row);
    E.block<3, 1>(6 * row.joint, i) =
        system.scale(row) * (joint.axes_a.transpose() * action.v);
    E.block<3, 1>(6 * row.joint + 3, i) =
        system.scale(row) * (joint.axes_a.transpose() * action.w);
  }
  return E;
}

MatrixXd row_compliance(const SolvingFrame& frame,
                        const ConstraintSystem& system,
                        const std::vector<PlacedJoint>& placed) {
  const MatrixXd E = components_of_rows(frame, system, placed);
  return E.transpose() * compliances(frame).asDiagonal() * E;
}

SharedReactions share_reactions(const SolvingFrame& frame,
                                const ConstraintSystem& system,
                                const std::vector<PlacedJoint>& placed,
                                const JacobianFactor& factor,
                                const VectorXd& f) {
  SharedReactions result;
  result.lambda = factor.solve_transposed(f);
  const MatrixXd E = components_of_rows(frame, system, placed);
  result.components = E * result.lambda;
  result.unique.assign(static_cast<std::size_t>(E.rows()), true);
  result.spread = VectorXd::Zero(E.rows());
  const MatrixXd N = factor.left_null_space();
  if (N.cols() == 0) return result;

  const VectorXd c = compliances(frame);
  const MatrixXd EN = E * N;
  const VectorXd root = c.cwiseSqrt();
  const Eigen::ColPivHouseholderQR<MatrixXd> least_squares(root.asDiagonal() *
                                                           EN);
  result.lambda -=
      N * least_squares.solve(root.asDiagonal() * result.components);
  result.components = E * result.lambda;

  constexpr double kRoundOff = 1e-7;  // of entries that ought to be zero
  const Index joints = joint_components(frame);
  for (Index i = 0; i < EN.rows(); ++i) {
    const double unit = i < joints && i % 6 >= 3 ? frame.length : 1.0;
    result.unique[static_cast<std::size_t>(i)] =
        EN.row(i).norm() <= kRoundOff * unit;
  }
  // dw = −X Xᵀ (w ∘ dc), X = E N R⁻¹ and RᵀR = Nᵀ Eᵀ C E N
  const Index open = EN.cols();
  const auto R = least_squares.matrixR()
                     .topLeftCorner(open, open)
                     .template triangularView<Eigen::Upper>();
  const MatrixXd X =
      R.transpose()
          .solve((EN * least_squares.colsPermutation()).transpose().eval())
          .transpose();
  const VectorXd weight = c.cwiseProduct(result.components.cwiseAbs());
  result.spread = std::numbers::ln2 * ((X * X.transpose()).cwiseAbs() * weight);
  return result;
}

}  // namespace clevis::mechanism
