#include "mechanism/initial_state.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "mechanism/assembly.h"
#include "mechanism/closed_joints.h"
#include "mechanism/drive_law.h"
#include "mechanism/jacobian_factor.h"
#include "mechanism/mobility.h"
#include "mechanism/singular_start.h"

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

Configuration assembled(const MechanismDefinition& definition,
                        const SolvingFrame& frame, Motions motions,
                        double tolerance) {
  const Prescribed wanted = prescribed(definition);
  const ConstraintSystem system(frame, wanted.drives, motions,
                                ConstraintSystem::Drives::kAll);
  const Assembled result =
      assemble(system, frame.placement, wanted.values, tolerance);
  if (!result.closed) {
    MechanismDefinition with_initial = definition;
    with_initial.drives = wanted.drives;
    refuse_open(open_joints(with_initial, system, result.residual, tolerance),
                "all joints with the drives and initial coordinates");
  }
  return result.x;
}

/// Velocities where the joints leave as much freedom as everywhere: rates of
/// joints and drives exactly, those of bodies as near as the joints allow.
VectorXd regular_velocities(const MechanismDefinition& definition,
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
  JacobianFactor factor;
  factor.compute(J);
  VectorXd v = guess + factor.solve(rates - J * guess);
  const VectorXd left = J * v - rates;
  const double size = std::max(rates.lpNorm<Eigen::Infinity>(),
                               guess.lpNorm<Eigen::Infinity>());
  const double miss = left.size() > 0 ? left.lpNorm<Eigen::Infinity>() : 0.0;
  if (miss > 1e-6 * size) refuse_rates(definition, miss);
  return v;
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
  const int open =
      joints.columns() - numerical_rank(joints.jacobian(joints.place(state.x)));
  if (open <= freedom.joints) {
    state.velocities = regular_velocities(definition, joints, state.x, wanted);
    return state;
  }
  SingularStart start = singular_start(definition, frame, joints, state.x,
                                       wanted, freedom.joints);
  state.x = std::move(start.point.x);
  state.velocities = std::move(start.velocities);
  return state;
}

}  // namespace clevis::mechanism
