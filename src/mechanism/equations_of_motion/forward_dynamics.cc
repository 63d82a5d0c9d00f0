#include "mechanism/equations_of_motion/forward_dynamics.h"

namespace clevis::mechanism {

using Eigen::Index;
using Eigen::VectorXd;

ForwardDynamics::ForwardDynamics(const MechanismDefinition& definition,
                                 const SolvingFrame& frame, double tolerance,
                                 double duration)
    : equations_(definition, frame),
      loads_(equations_.loads()),
      scales_(equations_.layout(), tolerance, duration),
      projection_(equations_),
      tangents_(equations_, scales_),
      force_(VectorXd::Zero(equations_.constraints().columns())) {}

void ForwardDynamics::rate(double t, const VectorXd& y, VectorXd& rate) {
  const StateLayout& layout = equations_.layout();
  const MotionSolution& solution = equations_.solve(t, y);
  const MechanismState& state = equations_.state();
  layout.put_position_rates(y, state, rate);
  rate.segment(layout.velocity_index(), layout.velocities()) =
      solution.accelerations.head(layout.velocities());
  put_internal_rates(state.loads.forces, rate.data() + layout.internal_index());
  rate[layout.work_index()] = equations_.drives().add_power(
      equations_.targets(), solution.multipliers,
      solution.following_power + state.loads.power(state.twists));
}

void ForwardDynamics::error_weights(const VectorXd& y,
                                    VectorXd& weights) const {
  scales_.put_error_weights(y, loads_.forces(), weights);
}

void ForwardDynamics::scales(const VectorXd& y, VectorXd& scales) const {
  scales_.put_scales(y, loads_.forces(), scales);
}

void ForwardDynamics::hold_tangents(double t, const VectorXd& y) {
  equations_.hold_tangents(t, y);
}

void ForwardDynamics::effort_response(Index k, Eigen::Ref<VectorXd> rate) {
  const StateLayout& layout = equations_.layout();
  const std::size_t which = loads_.element_of_effort(k);
  const JointModel& line = loads_.forces().element(which).line;
  const ElementResponse& e = equations_.state().loads.forces.elements[which];
  force_.setZero();
  layout.add_lever(line.a, e.levers.a, force_);
  layout.add_lever(line.b, e.levers.b, force_);
  const MotionSolution& response = equations_.respond(force_);
  rate.setZero();
  rate.segment(layout.velocity_index(), layout.velocities()) =
      response.accelerations.head(layout.velocities());
  rate[layout.work_index()] = equations_.drives().add_power(
      equations_.targets(), response.multipliers, e.rate);
}

void ForwardDynamics::note_speed(const VectorXd& y) {
  scales_.note(y, equations_.solution().accelerations,
               equations_.constraints().mass().smallest_pivot(),
               loads_.forces());
}

}  // namespace clevis::mechanism
