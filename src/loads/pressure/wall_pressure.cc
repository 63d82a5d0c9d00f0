#include "loads/pressure/wall_pressure.h"

#include <cassert>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace clevis::loads {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

namespace {

/// Minimises ½ Σ w max(0, gᵀy)² − bᵀy, whose gradient's root are the pressures
/// gᵀy that make b: convex, and a quadratic as long as the same points press.
class PressingPoints {
 public:
  /// @param g  unit pressures' wrenches in the directions that count: a column
  ///   per point.
  PressingPoints(const MatrixXd& g, const VectorXd& weights)
      : g_(g), weights_(weights) {}

  /// Newton's method with halved steps. @return nothing if there is no minimum.
  std::optional<VectorXd> solve(const VectorXd& b) const {
    constexpr int kSteps = 100;
    constexpr double kEnough = 1e-11;
    // All points as if they could pull: at least half of it is true.
    VectorXd y = matrix(VectorXd::Ones(g_.cols())).ldlt().solve(b);
    for (int step = 0; step < kSteps; ++step) {
      const VectorXd pressure = (g_.transpose() * y).cwiseMax(0.0);
      const VectorXd rest = b - g_ * weights_.cwiseProduct(pressure);
      if (rest.norm() <= kEnough * b.norm()) return pressure;
      const VectorXd presses = (pressure.array() > 0.0).cast<double>().matrix();
      const VectorXd way = matrix(presses).ldlt().solve(rest);
      if (!way.allFinite()) return std::nullopt;
      y += step_length(y, way, b) * way;
    }
    return std::nullopt;
  }

 private:
  double energy(const VectorXd& y, const VectorXd& b) const {
    const VectorXd pressure = (g_.transpose() * y).cwiseMax(0.0);
    return 0.5 * weights_.dot(pressure.cwiseAbs2()) - b.dot(y);
  }

  /// Σ w g gᵀ of the points that press; not singular where few do.
  MatrixXd matrix(const VectorXd& presses) const {
    constexpr double kLeast = 1e-10;
    const VectorXd w = weights_.cwiseProduct(presses);
    const MatrixXd all = g_ * weights_.asDiagonal() * g_.transpose();
    MatrixXd result = g_ * w.asDiagonal() * g_.transpose();
    result.diagonal().array() += kLeast * all.trace();
    return result;
  }

  double step_length(const VectorXd& y, const VectorXd& way,
                     const VectorXd& b) const {
    constexpr double kShortest = 1e-6;
    constexpr double kRoundOff = 1e-12;
    const double here = energy(y, b);
    const double now = here + kRoundOff * std::abs(here);
    double length = 1.0;
    while (length > kShortest && energy(y + length * way, b) > now) {
      length *= 0.5;
    }
    return length;
  }

  const MatrixXd& g_;
  const VectorXd& weights_;
};

}  // namespace

std::optional<Matrix3Xd> wall_pressure(const GroupQuadrature& quadrature,
                                       const Matrix3Xd& outward,
                                       const Wrench& wrench,
                                       const Vector3d& about) {
  constexpr double kCarried = 1e-8;  // of the largest share of a direction
  const Index n = quadrature.weights.size();
  assert(outward.cols() == n);
  const Vector3d centre =
      quadrature.points * quadrature.weights / quadrature.weights.sum();
  const Matrix3Xd arms = quadrature.points.colwise() - centre;
  const double size = std::sqrt(arms.colwise().squaredNorm().maxCoeff());
  // Wrench of a unit of pressure at each point about the centre; moments over
  // the size.
  MatrixXd unit(6, n);
  for (Index q = 0; q < n; ++q) {
    const Vector3d push = -outward.col(q);
    const Vector3d arm = arms.col(q);
    unit.col(q) << push, arm.cross(push) / size;
  }
  Vector6d wanted;
  wanted << wrench.force,
      (wrench.moment + (about - centre).cross(wrench.force)) / size;
  const Matrix6d gram =
      unit * quadrature.weights.asDiagonal() * unit.transpose();
  const Eigen::SelfAdjointEigenSolver<Matrix6d> eigen(gram);
  const Index carried =
      (eigen.eigenvalues().array() > kCarried * eigen.eigenvalues()[5]).count();
  const MatrixXd directions = eigen.eigenvectors().rightCols(carried);
  const VectorXd b = directions.transpose() * wanted;
  if (b.norm() <= 1e-14 * wanted.norm() || !(wanted.norm() > 0.0)) {
    return Matrix3Xd::Zero(3, n);
  }
  const MatrixXd g = directions.transpose() * unit;
  const auto pressure = PressingPoints(g, quadrature.weights).solve(b);
  if (!pressure) return std::nullopt;
  return -outward * pressure->asDiagonal();
}

}  // namespace clevis::loads
