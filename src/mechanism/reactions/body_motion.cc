#include "mechanism/reactions/body_motion.h"

#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

namespace clevis::mechanism {

using Eigen::Vector3d;

BodyState body_motion(const SolvingFrame& frame, BodyIndex body,
                      const BodyPlacement& placement, const Twist& twist,
                      const SpatialAcceleration& acceleration) {
  const auto& R_WP = frame.R_WP;
  const Vector3d lever =
      -(placement.R * frame.p_LM[static_cast<std::size_t>(body)]);
  const Vector3d& w = twist.w;
  BodyState state;
  state.pose.R_WL = R_WP * placement.R;
  state.pose.p_WL = R_WP * (placement.p + lever);
  state.v_WLo = R_WP * (twist.v + w.cross(lever));
  state.w_WL = R_WP * w;
  state.a_WLo = R_WP * (acceleration.v + acceleration.w.cross(lever) +
                        w.cross(w.cross(lever)));
  state.alpha_WL = R_WP * acceleration.w;
  return state;
}

void put_forces(const SolvingFrame& frame, const ConstraintSystem& system,
                const std::vector<PlacedJoint>& placed,
                Equilibrium::Solution forces, Instant& instant) {
  for (JointReaction& reaction : forces.joints) {
    reaction.p_WJ = frame.R_WP * reaction.p_WJ;
    reaction.f_W = frame.R_WP * reaction.f_W;
    reaction.t_W = frame.R_WP * reaction.t_W;
    reaction.R_WJ = frame.R_WP * reaction.R_WJ;
  }
  instant.joints = std::move(forces.joints);
  for (std::size_t k = 0; k < instant.drives.size(); ++k) {
    const auto& row = system.row_list()[static_cast<std::size_t>(
        system.joint_rows() + static_cast<int>(k))];
    const SpatialForce action =
        placed[static_cast<std::size_t>(row.joint)].action(row.row);
    instant.drives[k].effort = forces.efforts[k];
    instant.drives[k].axis_W =
        frame.R_WP * (row.row.is_angle() ? action.w : action.v);
  }
  for (CouplingState& coupling : forces.couplings) {
    for (Vector3d* vector :
         {&coupling.f_1_W, &coupling.t_1_W, &coupling.f_2_W, &coupling.t_2_W}) {
      *vector = frame.R_WP * *vector;
    }
    if (!coupling.teeth) continue;
    coupling.teeth->f_W = frame.R_WP * coupling.teeth->f_W;
    coupling.teeth->p_W = frame.R_WP * coupling.teeth->p_W;
  }
  instant.couplings = std::move(forces.couplings);
}

namespace {

/// @param turn  from the axes that it has to those that it gets.
void turn_axes(const Eigen::Matrix3d& turn, JointReaction& reaction) {
  constexpr double kRoundOff = 1e-9;
  const auto unique = reaction.unique_components;
  const auto spread = reaction.spread;
  for (std::size_t k = 0; k < unique.size(); ++k) {
    const std::size_t first = k < 3 ? 0 : 3;
    reaction.unique_components[k] = true;
    reaction.spread[k] = 0.0;
    for (std::size_t i = first; i < first + 3; ++i) {
      const double share = std::abs(turn(static_cast<Eigen::Index>(k - first),
                                         static_cast<Eigen::Index>(i - first)));
      if (share <= kRoundOff) continue;
      reaction.unique_components[k] &= unique[i];
      reaction.spread[k] += share * spread[i];
    }
  }
}

void refer_to_given_frames(const MechanismDefinition& definition,
                           Instant& instant) {
  constexpr double kSame = 1e-9;
  for (std::size_t j = 0; j < instant.joints.size(); ++j) {
    const JointDefinition& joint = definition.joints[j];
    const Eigen::Matrix3d R_WL =
        joint.body_a == kGround
            ? Eigen::Matrix3d(Eigen::Matrix3d::Identity())
            : instant.bodies[static_cast<std::size_t>(joint.body_a)].pose.R_WL;
    const Eigen::Matrix3d given = R_WL * joint.frame_a.R_LJ;
    JointReaction& reaction = instant.joints[j];
    if ((given - reaction.R_WJ).norm() < kSame) continue;
    turn_axes(given.transpose() * reaction.R_WJ, reaction);
    reaction.R_WJ = given;
  }
}

}  // namespace

void refer_to_given_frames(const MechanismDefinition& definition,
                           Motion& motion) {
  for (auto* instants : {&motion.instants, &motion.repeats}) {
    for (Instant& instant : *instants) {
      refer_to_given_frames(definition, instant);
    }
  }
  for (ChangePoint& point : motion.change_points) {
    if (point.at) refer_to_given_frames(definition, *point.at);
  }
}

}  // namespace clevis::mechanism
