#include "mechanism/neighbours/neighbour_inertia.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "base/values/index.h"
#include "mechanism/joints/cross_matrix.h"

namespace clevis::mechanism {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;

constexpr Index kTwist = 6;
// Of rows of pure numbers, and of bodies' masses: less is round-off.
constexpr double kRoundOff = 1e-9;

/// Rows of the body as wrenches by place, 6 places × rows.
MatrixXd wrenches_of(const Neighbours& neighbours, const NeighbourRows& rows) {
  const SolvingFrame& frame = neighbours.frame();
  const Eigen::Matrix3d R_LP = rows.x[index(neighbours.slot())].R.transpose();
  const Vector3d& p_LM = frame.p_LM[index(neighbours.slot() - 1)];
  MatrixXd all =
      MatrixXd::Zero(kTwist * std::ssize(rows.places), rows.body.rows());
  for (Index k = 0; k < rows.body.rows(); ++k) {
    const Vector3d force = R_LP * rows.body.row(k).head<3>().transpose();
    const Vector3d moment = R_LP * rows.body.row(k).tail<3>().transpose();
    auto wrench = all.col(k).segment<kTwist>(
        kTwist * static_cast<Index>(rows.place_of[index(k)]));
    wrench << force, frame.length * moment + p_LM.cross(force);
  }
  return all;
}

/// Of the neighbours' unknowns, as their masses: the moment θ' × h that turns a
/// momentum h [kg/s]. Empty: none.
MatrixXd spins_of(const Neighbours& neighbours, const Configuration& x,
                  const Instant& instant) {
  const auto& slots = neighbours.slots();
  const SolvingFrame& frame = neighbours.frame();
  const auto state_of = [&](int slot) -> const BodyState& {
    return instant.bodies[index(slot - 1)];
  };
  const Vector3d& own = state_of(neighbours.slot()).w_WL;
  const double square = frame.length * frame.length;
  MatrixXd spins =
      MatrixXd::Zero(kTwist * std::ssize(slots), kTwist * std::ssize(slots));
  for (std::size_t k = 0; k < slots.size(); ++k) {
    const auto& given =
        neighbours.definition().bodies[index(slots[k] - 1)].mass_properties;
    const Eigen::Matrix3d& R = x[index(slots[k])].R;
    const Vector3d spin =
        frame.R_WP.transpose() * (state_of(slots[k]).w_WL - own);
    const Vector3d momentum = R * given.inertia_LCm * R.transpose() * spin;
    const Index at = kTwist * static_cast<Index>(k) + 3;
    spins.block<3, 3>(at, at) = -cross_matrix(momentum) / square;
  }
  return spins.isZero(0.0) ? MatrixXd() : spins;
}

}  // namespace

NeighbourInertia neighbour_inertia(const Neighbours& neighbours,
                                   const Instant& instant) {
  const NeighbourRows rows = neighbours.rows(instant);
  const MatrixXd wrenches = wrenches_of(neighbours, rows);
  const MatrixXd& free = rows.free;
  NeighbourInertia found{.places = rows.places,
                         .held = wrenches,
                         .weighed = MatrixXd(wrenches.rows(), 0)};
  if (free.cols() == 0 || wrenches.cols() == 0) return found;
  const MatrixXd seen = rows.there * free;
  const Eigen::JacobiSVD<MatrixXd> svd(seen, Eigen::ComputeFullU);
  const Index follow = (svd.singularValues().array() > kRoundOff).count();
  const MatrixXd& U = svd.matrixU();
  found.held = wrenches * U.rightCols(U.cols() - follow);
  if (follow == 0) return found;
  MatrixXd mass = free.transpose() * neighbours.masses(rows.x) * free;
  mass.diagonal().array() += kRoundOff * kRoundOff * mass.diagonal().maxCoeff();
  const MatrixXd directions = seen.transpose() * U.leftCols(follow);
  const MatrixXd moved = mass.llt().solve(directions);
  const Eigen::LLT<MatrixXd> root(directions.transpose() * moved);
  // Added mass (L Lᵀ)⁻¹ = L⁻ᵀ L⁻¹ of the followed motions.
  found.weighed = wrenches * U.leftCols(follow) *
                  root.matrixU().solve(MatrixXd::Identity(follow, follow));
  const MatrixXd spins = spins_of(neighbours, rows.x, instant);
  if (spins.size() == 0) return found;
  // Speeds of the neighbours for unit motions that they follow.
  const MatrixXd speeds =
      free * moved * root.solve(MatrixXd::Identity(follow, follow));
  const MatrixXd of_followed = wrenches * U.leftCols(follow);
  found.spin = of_followed * (speeds.transpose() * spins * speeds) *
               of_followed.transpose();
  return found;
}

}  // namespace clevis::mechanism
