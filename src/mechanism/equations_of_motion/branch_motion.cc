// Motion by forces at a change point.
#include <Eigen/Geometry>
#include <Eigen/QR>
#include <Eigen/SVD>

#include "mechanism/change_points/singular_position.h"
#include "mechanism/equations_of_motion/forward_dynamics.h"

namespace clevis::mechanism {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

void ForwardDynamics::jacobian(double t, const VectorXd& y, MatrixXd& J) {
  place(t, y);
  system_.fill_jacobian(placed_, J);
}

Configuration ForwardDynamics::whole_configuration() const {
  Configuration x = x_;
  for (BodyPlacement& body : x) body.q = Eigen::Quaterniond(body.R);
  return x;
}

/// Velocities of the branch are v = G z; its accelerations G z' + G' z fulfil
/// Gᵀ M a = Gᵀ Q but for what drives and sticking friction fix, P a = γ.
std::optional<ForwardDynamics::BranchMotion> ForwardDynamics::branch_motion(
    double t, const VectorXd& y, int freedom) {
  // the inertia of rotors is no mass of a body: left open here
  if (columns_ > system_.columns()) return std::nullopt;
  rate(t, y, scratch_);
  const VectorXd v = u_;
  if (v.isZero(0.0)) return std::nullopt;
  const ConstraintSystem joints(frame_, {}, system_.motions(),
                                ConstraintSystem::Drives::kNone);
  const auto point = branch_point(joints, whole_configuration(), v, freedom);
  if (!point) return std::nullopt;
  const MatrixXd& G = point->tangents;
  const VectorXd z = point->coordinates.transpose() * v;
  const VectorXd curved = point->slopes * z;
  const Index fixed = rows_ - system_.joint_rows();
  system_.fill_jacobian(placed_, J_);  // not on trees by rate()
  const MatrixXd P = J_.middleRows(system_.joint_rows(), fixed) * G;
  const VectorXd wanted = gamma_.segment(system_.joint_rows(), fixed) -
                          J_.middleRows(system_.joint_rows(), fixed) * curved;
  VectorXd change = VectorXd::Zero(freedom);  // z'
  MatrixXd open = MatrixXd::Identity(freedom, freedom);
  if (fixed > 0) {
    const Eigen::JacobiSVD<MatrixXd> svd(
        P, Eigen::ComputeFullU | Eigen::ComputeFullV);
    change = svd.solve(wanted);
    open = svd.matrixV().rightCols(freedom - svd.rank());
  }
  const MatrixXd free = G * open;
  const MatrixXd heavy = mass_.mass_times(free);
  const VectorXd left =
      free.transpose() * Q_ - heavy.transpose() * (curved + G * change);
  if (free.cols() > 0) {
    change += open * (heavy.transpose() * free).ldlt().solve(left);
  }
  return BranchMotion{curved + G * change, free};
}

}  // namespace clevis::mechanism
