#include "mechanism/integration/initial_state.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <fmt/format.h>

#include "base/algebra/singular_vectors.h"
#include "base/messages/errors.h"
#include "mechanism/change_points/singular_start.h"
#include "mechanism/constraints/assembly.h"
#include "mechanism/constraints/closed_joints.h"
#include "mechanism/constraints/mobility.h"
#include "mechanism/drives/drive_law.h"
#include "numerics/factors/jacobian_factor.h"

namespace clevis::mechanism {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Drives, and after them the initial coordinates as drives.
struct Prescribed {
  std::vector<DriveDefinition> drives;
  VectorXd values;
};

Prescribed prescribed(const MechanismDefinition& definition) {
  Prescribed all{definition.drives, {}};
  std::vector<double> values;
  for (const DriveDefinition& drive : definition.drives) {
    values.push_back(drive_target(drive, 0.0).position);
  }
  for (const InitialJointState& initial : definition.initial_joints) {
    if (!initial.position) continue;
    DriveDefinition drive;
    drive.joint = initial.joint;
    drive.place = initial.place;
    all.drives.push_back(drive);
    values.push_back(*initial.position);
  }
  all.values = Eigen::Map<const VectorXd>(values.data(),
                                          static_cast<Index>(values.size()));
  return all;
}

/// @throws Error K007 if a joint's position is given twice.
void require_one_position_each(const MechanismDefinition& definition,
                               const Prescribed& wanted) {
  const std::vector<DriveDefinition>& all = wanted.drives;
  for (std::size_t i = definition.drives.size(); i < all.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const auto a = static_cast<Index>(i), b = static_cast<Index>(k);
      if (all[k].joint != all[i].joint || all[k].coordinate != 0 ||
          wanted.values[a] == wanted.values[b]) {
        continue;
      }
      const std::size_t joint = static_cast<std::size_t>(all[i].joint);
      throw Error("K007", all[i].place,
                  fmt::format("the initial position of joint {} contradicts "
                              "that of {}",
                              definition.joints[joint].name, all[k].place),
                  "Give it once.");
    }
  }
}

Configuration assembled(const MechanismDefinition& definition,
                        const SolvingFrame& frame, Motions motions,
                        double tolerance) {
  const Prescribed wanted = prescribed(definition);
  require_one_position_each(definition, wanted);
  const ConstraintSystem system(frame, wanted.drives, motions,
                                ConstraintSystem::Drives::kAll);
  const Assembled result = assemble(system, frame.placement, wanted.values,
                                    tolerance, frame.rank_threshold());
  if (!result.closed) {
    MechanismDefinition with_initial = definition;
    with_initial.drives = wanted.drives;
    refuse_open(with_initial,
                open_joints(with_initial, system, result.residual, tolerance),
                "all joints with the drives and initial coordinates");
  }
  return result.x;
}

/// M v about the bodies' centres of mass, in the unknowns of the system.
VectorXd momentum(const MechanismDefinition& definition,
                  const SolvingFrame& frame, const Configuration& x,
                  const VectorXd& v) {
  VectorXd result = v;
  const auto count = static_cast<Index>(definition.bodies.size());
  const Index n = v.size() / count;
  for (Index i = 0; i < count; ++i) {
    const auto body = static_cast<std::size_t>(i);
    const part::MassProperties& mass = definition.bodies[body].mass_properties;
    const Eigen::Matrix3d& R = x[body + 1].R;
    const Eigen::Matrix3d inertia =
        R * mass.inertia_LCm * R.transpose() / (frame.length * frame.length);
    auto part = result.segment(n * i, n);
    if (n == 3) {
      part.head<2>() *= mass.mass;
      part[2] *= inertia(2, 2);
    } else {
      part.head<3>() *= mass.mass;
      part.tail<3>() = (inertia * part.tail<3>()).eval();
    }
  }
  return result;
}

/// Momenta of motions, of some bodies or all.
MatrixXd momenta(const MechanismDefinition& definition,
                 const SolvingFrame& frame, const Configuration& x,
                 const MatrixXd& motions,
                 const std::vector<InitialBodyState>* some) {
  MatrixXd found(motions.rows(), motions.cols());
  for (Index k = 0; k < motions.cols(); ++k) {
    found.col(k) = momentum(definition, frame, x, motions.col(k));
  }
  if (some == nullptr) return found;
  const Index n = motions.rows() / static_cast<Index>(definition.bodies.size());
  MatrixXd of_some = MatrixXd::Zero(found.rows(), found.cols());
  for (const InitialBodyState& given : *some) {
    of_some.middleRows(n * given.body, n) = found.middleRows(n * given.body, n);
  }
  return of_some;
}

/// Chooses the part of v that J leaves open so that the kinetic energy of
/// v − guess is least: of the bodies that are given first, then of all.
void settle_open_velocities(const MechanismDefinition& definition,
                            const SolvingFrame& frame, const Configuration& x,
                            const MatrixXd& J, const VectorXd& guess,
                            VectorXd& v) {
  constexpr double kMoved = 1e-9;  // of the energy of all
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> rows;
  rows.setThreshold(numerics::kRankThreshold);
  rows.compute(J);
  const Index open = J.cols() - rows.rank();
  if (open == 0) return;
  const MatrixXd Z = rows.matrixZ();
  MatrixXd N = rows.colsPermutation() * Z.bottomRows(open).transpose();
  if (!definition.initial_bodies.empty()) {
    const MatrixXd all = momenta(definition, frame, x, N, nullptr);
    const MatrixXd given =
        momenta(definition, frame, x, N, &definition.initial_bodies);
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> shares(
        N.transpose() * given, N.transpose() * all);
    const VectorXd& share = shares.eigenvalues();
    const MatrixXd& vectors = shares.eigenvectors();
    const Index moved = (share.array() > kMoved).count();
    const MatrixXd U = vectors.rightCols(moved);
    v -= N * U *
         share.tail(moved).cwiseInverse().cwiseProduct(
             U.transpose() * given.transpose() * (v - guess));
    N *= MatrixXd(vectors.leftCols(open - moved));
    if (moved == open) return;
  }
  const MatrixXd MN = momenta(definition, frame, x, N, nullptr);
  v -= N * (N.transpose() * MN).ldlt().solve(MN.transpose() * (v - guess));
}

/// Velocities where the joints leave as much freedom as everywhere: rates of
/// joints and drives exactly, those of bodies as near as these allow, and those
/// that nothing gives as an impulse from rest leaves them.
VectorXd regular_velocities(const MechanismDefinition& definition,
                            const SolvingFrame& frame,
                            const ConstraintSystem& joints,
                            const Configuration& x, const WantedRates& wanted) {
  Index of_bodies = 0;
  VectorXd guess = VectorXd::Zero(joints.columns());
  for (const InitialBodyState& initial : definition.initial_bodies) {
    const Index n =
        joints.columns() / static_cast<Index>(definition.bodies.size());
    guess.segment(n * initial.body, n) = wanted.rates.segment(
        wanted.rates.size() -
            n * static_cast<Index>(definition.initial_bodies.size()) +
            of_bodies,
        n);
    of_bodies += n;
  }
  const Index exact = wanted.rates.size() - of_bodies;
  MatrixXd J(joints.rows() + exact, joints.columns());
  J << joints.jacobian(joints.place(x)), wanted.rows.topRows(exact);
  VectorXd rates = VectorXd::Zero(J.rows());
  rates.tail(exact) = wanted.rates.head(exact);
  numerics::JacobianFactor factor;
  factor.compute(J);
  VectorXd v = guess + factor.solve(rates - J * guess);
  settle_open_velocities(definition, frame, x, J, guess, v);
  const VectorXd left = J * v - rates;
  const double size = std::max(rates.lpNorm<Eigen::Infinity>(),
                               guess.lpNorm<Eigen::Infinity>());
  const double miss = left.size() > 0 ? left.lpNorm<Eigen::Infinity>() : 0.0;
  if (miss > 1e-6 * size) refuse_rates(definition, miss);
  return v;
}

/// A motion from rest lingers just beside a change point, where rows that fade
/// are left out of it; at the point itself it has a branch or is refused.
/// @throws Error K010.
void refuse_rest_beside_change_point(const MatrixXd& J, int freedom,
                                     const VectorXd& velocities) {
  constexpr double kMost = 1.5 * numerics::kRankThreshold, kAtThePoint = 1e-9;
  const Index rank = J.cols() - freedom;
  if (rank < 1 || velocities.lpNorm<Eigen::Infinity>() > 0.0) return;
  const VectorXd values = singular_values(J);
  if (values.size() < rank) return;
  const double weakest = values[rank - 1] / values[0];
  if (weakest <= kAtThePoint || weakest >= kMost) return;
  throw Error("K010", "mechanism",
              "the motion starts at rest just beside a change point, where the "
              "joints do not say clearly which way leads on",
              "Give [[initial]] a rate that leads away, or start farther "
              "beside the change point, by a thousandth of a radian.");
}

}  // namespace

InitialState initial_state(const MechanismDefinition& definition,
                           const SolvingFrame& frame,
                           const ConstraintSystem& system, double tolerance) {
  const Mobility freedom =
      mobility(frame, system, closed_joints(definition, frame, tolerance));
  if (!freedom.dependent_drives.empty()) require_driven(definition, freedom);
  InitialState state;
  state.freedom = freedom.joints;
  state.rank = system.columns() - freedom.with_drives;
  state.x = assembled(definition, frame, system.motions(), tolerance);
  const WantedRates wanted =
      wanted_rates(definition, frame, system.motions(), state.x);
  const ConstraintSystem joints(frame, {}, system.motions(),
                                ConstraintSystem::Drives::kNone);
  const MatrixXd J = joints.jacobian(joints.place(state.x));
  const int open = joints.columns() - numerics::numerical_rank(J);
  if (open <= freedom.joints) {
    state.velocities =
        regular_velocities(definition, frame, joints, state.x, wanted);
    if (!frame.is_tree) {
      refuse_rest_beside_change_point(J, freedom.joints, state.velocities);
    }
    return state;
  }
  SingularStart start = singular_start(definition, frame, joints, state.x,
                                       wanted, freedom.joints);
  state.x = std::move(start.point.x);
  state.velocities = std::move(start.velocities);
  refuse_rest_beside_change_point(J, freedom.joints, state.velocities);
  return state;
}

}  // namespace clevis::mechanism
