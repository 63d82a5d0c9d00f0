#include "mechanism/compliance/reaction_sharing.h"

#include <cstddef>
#include <numbers>

#include <Eigen/QR>

#include "mechanism/compliance/compliance_maps.h"

namespace clevis::mechanism {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A P R⁻¹ of a factorisation Q R = B P.
MatrixXd times_inverse_root(const MatrixXd& A,
                            const Eigen::ColPivHouseholderQR<MatrixXd>& qr) {
  const Index n = A.cols();
  const auto R =
      qr.matrixR().topLeftCorner(n, n).template triangularView<Eigen::Upper>();
  return R.transpose()
      .solve((A * qr.colsPermutation()).transpose().eval())
      .transpose();
}

}  // namespace

SharedReactions share_reactions(const SolvingFrame& frame,
                                const ConstraintSystem& system,
                                const std::vector<PlacedJoint>& placed,
                                const numerics::JacobianFactor& factor,
                                const VectorXd& f,
                                const std::vector<VectorXd>& strains) {
  SharedReactions result;
  result.lambda = factor.solve_transposed(f);
  const ComplianceMaps way = compliance_maps(frame, system, placed);
  const MatrixXd& E = way.components;
  result.components = E * result.lambda;
  result.unique.assign(static_cast<std::size_t>(E.rows()), true);
  result.spread = VectorXd::Zero(E.rows());
  const MatrixXd N = factor.left_null_space();
  if (N.cols() == 0) return result;

  const MatrixXd EN = E * N;
  const MatrixXd BN = way.energy_root * N;
  const Eigen::ColPivHouseholderQR<MatrixXd> least_squares(BN);
  VectorXd beside = VectorXd::Zero(way.energy_root.rows());
  for (std::size_t k = 0; k < strains.size(); ++k) {
    beside.segment(way.link_rows[k], strains[k].size()) = strains[k];
  }
  result.lambda -=
      N * least_squares.solve(way.energy_root * result.lambda + beside);
  result.components = E * result.lambda;

  constexpr double kRoundOff = 1e-7;  // of entries that ought to be zero
  const Index joints = 6 * static_cast<Index>(frame.joints.size());
  for (Index i = 0; i < EN.rows(); ++i) {
    const double unit = i < joints && i % 6 >= 3 ? frame.length : 1.0;
    result.unique[static_cast<std::size_t>(i)] =
        EN.row(i).norm() <= kRoundOff * unit;
  }
  // dw = −X (Yᵀ d(Bᵀ B) λ), X = E N R⁻¹, Y = B N R⁻¹ and RᵀR = Nᵀ Bᵀ B N
  const MatrixXd X = times_inverse_root(EN, least_squares);
  const VectorXd weight =
      way.compliance.cwiseProduct(result.components.cwiseAbs());
  result.spread = (X * X.transpose()).cwiseAbs() * weight;
  const MatrixXd Y = times_inverse_root(BN, least_squares);
  const VectorXd strain = way.energy_root * result.lambda + beside;
  for (std::size_t k = 0; k + 1 < way.link_rows.size(); ++k) {
    const Index first = way.link_rows[k], rows = way.link_rows[k + 1] - first;
    result.spread += (X * (Y.middleRows(first, rows).transpose() *
                           strain.segment(first, rows)))
                         .cwiseAbs();
  }
  result.spread *= std::numbers::ln2;
  return result;
}

}  // namespace clevis::mechanism
