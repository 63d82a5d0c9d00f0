#include "mechanism/reactions/held_lines.h"

#include <cmath>

#include "mechanism/compliance/compliance_maps.h"
#include "numerics/factors/jacobian_factor.h"

namespace clevis::mechanism {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr double kRoundOff = 1e-7;  // of entries that ought to be zero

std::vector<std::size_t> held_lines(const ForceModel& forces) {
  std::vector<std::size_t> held;
  for (std::size_t k = 0; k < forces.size(); ++k) {
    const int mode = forces.element(k).modes[0];
    if (forces.element(k).is_dry() && (mode == 0 || std::abs(mode) >= 2)) {
      held.push_back(k);
    }
  }
  return held;
}

/// Rows of the joints and drives, then of the lines.
MatrixXd all_rows(const ConstraintSystem& system,
                  const std::vector<PlacedJoint>& placed,
                  const ForceModel& forces, const ForceState& acting,
                  const std::vector<std::size_t>& held, std::size_t slots) {
  MatrixXd J(system.rows() + static_cast<Index>(held.size()), system.columns());
  J.topRows(system.rows()) = system.jacobian(placed);
  for (std::size_t i = 0; i < held.size(); ++i) {
    const ActingElement& e = forces.element(held[i]);
    const PlacedJoint::Levers& along = acting.elements[held[i]].levers;
    std::vector<SpatialForce> levers(slots);
    levers[static_cast<std::size_t>(e.line.a)] = along.a;
    levers[static_cast<std::size_t>(e.line.b)] = along.b;
    J.row(system.rows() + static_cast<Index>(i)) =
        system.scale(e.row) * system.wrench_vector(levers);
  }
  return J;
}

void mark_joints(const SolvingFrame& frame, const MatrixXd& open,
                 Instant& instant) {
  const auto joints = static_cast<Index>(6 * instant.joints.size());
  for (Index i = 0; i < open.rows(); ++i) {
    const double unit = i < joints && i % 6 >= 3 ? frame.length : 1.0;
    if (open.row(i).norm() <= kRoundOff * unit) continue;
    if (i >= joints) {
      instant.couplings[static_cast<std::size_t>(i - joints)].unique = false;
      continue;
    }
    JointReaction& joint = instant.joints[static_cast<std::size_t>(i / 6)];
    joint.unique = false;
    joint.unique_components[static_cast<std::size_t>(i % 6)] = false;
  }
}

}  // namespace

void mark_what_friction_leaves_open(const SolvingFrame& frame,
                                    const ConstraintSystem& system,
                                    const std::vector<PlacedJoint>& placed,
                                    const ForceModel& forces,
                                    const ForceState& acting,
                                    Instant& instant) {
  const std::vector<std::size_t> held = held_lines(forces);
  if (held.empty()) return;
  numerics::JacobianFactor factor;
  factor.compute(
      all_rows(system, placed, forces, acting, held, frame.placement.size()));
  const MatrixXd N = factor.left_null_space();
  if (N.cols() == 0) return;
  for (std::size_t i = 0; i < held.size(); ++i) {
    const Index row = system.rows() + static_cast<Index>(i);
    instant.elements[held[i]].unique = N.row(row).norm() <= kRoundOff;
  }
  const MatrixXd E = components_of_rows(frame, system, placed);
  mark_joints(frame, E * N.topRows(system.rows()), instant);
}

}  // namespace clevis::mechanism
