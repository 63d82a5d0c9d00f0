#include "mechanism/equations_of_motion/branch_motion.h"

#include <Eigen/Geometry>
#include <Eigen/QR>

#include "base/algebra/singular_vectors.h"
#include "mechanism/change_points/singular_position.h"

namespace clevis::mechanism {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Configuration with_quaternions(Configuration x) {
  for (BodyPlacement& body : x) body.q = Eigen::Quaterniond(body.R);
  return x;
}

/// Velocities of the branch are v = G z; its accelerations G z' + G' z fulfil
/// Gᵀ M a = Gᵀ Q but for what drives and sticking friction fix, P a = γ.
std::optional<BranchMotion> branch_motion(EquationsOfMotion& equations,
                                          const SolvingFrame& frame, double t,
                                          const VectorXd& y, int freedom) {
  MotionConstraints& constraints = equations.constraints();
  // the inertia of rotors is no mass of a body: left open here
  if (constraints.has_rotors()) return std::nullopt;
  const MotionSolution& solution = equations.solve(t, y);
  const MechanismState& state = equations.state();
  const VectorXd& v = state.speeds;
  if (v.isZero(0.0)) return std::nullopt;
  const ConstraintSystem joints(frame, {}, equations.system().motions(),
                                ConstraintSystem::Drives::kNone);
  const auto point =
      branch_point(joints, with_quaternions(state.x), v, freedom);
  if (!point) return std::nullopt;
  const MatrixXd& G = point->tangents;
  const VectorXd z = point->coordinates.transpose() * v;
  const VectorXd curved = point->slopes * z;
  const Index first = equations.system().joint_rows();
  const Index fixed = constraints.rows() - first;
  // not there yet on trees
  const auto J = constraints.with_joint_rows(state.placed);
  const MatrixXd P = J.middleRows(first, fixed) * G;
  const VectorXd wanted = solution.row_accelerations.segment(first, fixed) -
                          J.middleRows(first, fixed) * curved;
  VectorXd change = VectorXd::Zero(freedom);  // z'
  MatrixXd open = MatrixXd::Identity(freedom, freedom);
  if (fixed > 0) {
    constexpr double kRoundOff = 1e-14;
    const SingularVectors fixing = singular_vectors(P);
    const Eigen::Index rank = fixing.rank(kRoundOff);
    change =
        fixing.V.leftCols(rank) * (fixing.U.leftCols(rank).transpose() * wanted)
                                      .cwiseQuotient(fixing.sigma.head(rank));
    open = fixing.left(rank);
  }
  const MatrixXd free = G * open;
  const MatrixXd heavy = constraints.mass().mass_times(free);
  const VectorXd left = free.transpose() * solution.forces -
                        heavy.transpose() * (curved + G * change);
  if (free.cols() > 0) {
    change += open * (heavy.transpose() * free).ldlt().solve(left);
  }
  return BranchMotion{curved + G * change, free};
}

}  // namespace clevis::mechanism
