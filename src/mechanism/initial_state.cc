#include "mechanism/initial_state.h"

#include <algorithm>
#include <string>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "base/errors.h"
#include "mechanism/assembly.h"
#include "mechanism/closed_joints.h"
#include "mechanism/drive_law.h"
#include "mechanism/jacobian_factor.h"
#include "mechanism/mobility.h"

namespace clevis::mechanism {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Drives, and after them the initial coordinates or rates as drives.
struct Prescribed {
  std::vector<DriveDefinition> drives;
  VectorXd values;
};

enum class Order { kPosition, kRate };

Prescribed prescribed(const MechanismDefinition& definition, Order order) {
  Prescribed all{definition.drives, {}};
  std::vector<double> values;
  for (const DriveDefinition& drive : definition.drives) {
    const DriveTarget target = drive_target(drive, 0.0);
    values.push_back(order == Order::kPosition ? target.position : target.rate);
  }
  for (const InitialJointState& initial : definition.initial_joints) {
    const auto& value =
        order == Order::kPosition ? initial.position : initial.rate;
    if (!value) continue;
    DriveDefinition drive;
    drive.joint = initial.joint;
    drive.place = initial.place;
    all.drives.push_back(drive);
    values.push_back(*value);
  }
  all.values = Eigen::Map<const VectorXd>(values.data(),
                                          static_cast<Index>(values.size()));
  return all;
}

Configuration assembled(const MechanismDefinition& definition,
                        const SolvingFrame& frame, Motions motions,
                        double tolerance) {
  const Prescribed wanted = prescribed(definition, Order::kPosition);
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

/// Unknowns' rates that the scene wants of the bodies, whatever the joints.
VectorXd wanted_velocities(const MechanismDefinition& definition,
                           const SolvingFrame& frame,
                           const ConstraintSystem& system,
                           const Configuration& x) {
  std::vector<Twist> twists(x.size());
  for (const InitialBodyState& initial : definition.initial_bodies) {
    const auto slot = static_cast<std::size_t>(initial.body) + 1;
    Twist& twist = twists[slot];
    twist.w = frame.R_WP.transpose() * initial.w_WL;
    const Vector3d lever = x[slot].R * frame.p_LM[slot - 1];
    twist.v = frame.R_WP.transpose() * initial.v_WLo + twist.w.cross(lever);
    twist.w *= frame.length * frame.length;  // as wrench_vector() divides
  }
  return system.wrench_vector(twists);
}

}  // namespace

InitialState initial_state(const MechanismDefinition& definition,
                           const SolvingFrame& frame,
                           const ConstraintSystem& system, double tolerance) {
  const Mobility freedom =
      mobility(frame, system, closed_joints(definition, frame, tolerance));
  if (!freedom.dependent_drives.empty()) require_driven(definition, freedom);
  InitialState state;
  state.x = assembled(definition, frame, system.motions(), tolerance);
  const Prescribed wanted = prescribed(definition, Order::kRate);
  const ConstraintSystem rows(frame, wanted.drives, system.motions(),
                              ConstraintSystem::Drives::kAll);
  VectorXd rates = VectorXd::Zero(rows.rows());
  for (Index i = 0; i < wanted.values.size(); ++i) {
    const auto& row =
        rows.row_list()[static_cast<std::size_t>(rows.joint_rows() + i)];
    rates[rows.joint_rows() + i] = rows.scale(row) * wanted.values[i];
  }
  const Eigen::MatrixXd J = rows.jacobian(rows.place(state.x));
  JacobianFactor factor;
  factor.compute(J);
  const VectorXd guess = wanted_velocities(definition, frame, system, state.x);
  state.velocities = guess + factor.solve(rates - J * guess);
  const VectorXd left = J * state.velocities - rates;
  const double size = std::max(rates.lpNorm<Eigen::Infinity>(),
                               guess.lpNorm<Eigen::Infinity>());
  if (left.size() > 0 && left.lpNorm<Eigen::Infinity>() > 1e-6 * size) {
    throw Error("K007",
                definition.initial_joints.empty()
                    ? std::string("mechanism")
                    : definition.initial_joints.front().place,
                fmt::format("the initial rates contradict the joints or one "
                            "another by {:.3g} m/s",
                            left.lpNorm<Eigen::Infinity>()),
                "give one rate per degree of freedom");
  }
  return state;
}

}  // namespace clevis::mechanism
