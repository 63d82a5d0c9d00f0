#include "mechanism/reactions/body_motion.h"

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
  }
  instant.couplings = std::move(forces.couplings);
}

}  // namespace clevis::mechanism
