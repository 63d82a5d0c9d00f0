#include "mechanism/dynamic_state/turn_counter.h"

#include "base/values/index.h"
#include "mechanism/joints/joint_types.h"

namespace clevis::mechanism {

using Eigen::Vector3d;
using Eigen::VectorXd;

TurnCounter::TurnCounter(const SolvingFrame& frame, const StateLayout& layout,
                         const ForceModel& forces)
    : frame_(frame), layout_(layout) {
  for (const double angle : frame.placement.angles) {
    turns_.push_back({angle, 0.0, 0.0});
  }
  for (std::size_t k = 0; frame.planar && k < forces.size(); ++k) {
    const ActingElement& e = forces.element(k);
    if (e.joint < 0 || !e.row.is_angle()) continue;
    plane_angles_.push_back({k, index(e.joint), e.anchor.q});
  }
}

void TurnCounter::start(const Configuration& x, const VectorXd& y) {
  for (std::size_t j = 0; j < turns_.size(); ++j) {
    turns_[j] = {
        x.angle(j), 0.0,
        frame_.planar ? layout_.plane_angle(frame_.joints[j], y) : 0.0};
  }
}

void TurnCounter::count(double t, const VectorXd& y, MechanismState& state,
                        ForceModel& forces) const {
  for (std::size_t j = 0; j < turns_.size(); ++j) {
    if (!traits(frame_.joints[j].type).turns_about_z) continue;
    state.x.angles[j] = turns_[j].angle + turned_since(j, t, y, state);
  }
  if (!frame_.planar) return;
  for (const PlaneAngle& known : plane_angles_) {
    const double turned = layout_.plane_angle(frame_.joints[known.joint], y) -
                          turns_[known.joint].plane_angle;
    forces.element(known.element).anchor = {known.accepted + turned, 0.0, t};
  }
}

double TurnCounter::turned_since(std::size_t j, double t, const VectorXd& y,
                                 const MechanismState& state) const {
  const JointModel& joint = frame_.joints[j];
  const Turn& turn = turns_[j];
  if (frame_.planar) return layout_.plane_angle(joint, y) - turn.plane_angle;
  const Vector3d w =
      state.twists[index(joint.b)].w - state.twists[index(joint.a)].w;
  const Vector3d axis = state.x[index(joint.a)].R * joint.frame_a.R_LJ.col(2);
  return 0.5 * (turn.rate + axis.dot(w)) * (t - accepted_at_);
}

void TurnCounter::accept(double t, const VectorXd& y,
                         const MechanismState& state) {
  accepted_at_ = t;
  for (std::size_t j = 0; j < turns_.size(); ++j) {
    const JointModel& joint = frame_.joints[j];
    if (!traits(joint.type).turns_about_z) continue;
    const Vector3d w =
        state.twists[index(joint.b)].w - state.twists[index(joint.a)].w;
    turns_[j] = {state.placed[j].turned(), state.placed[j].axes_a.col(2).dot(w),
                 frame_.planar ? layout_.plane_angle(joint, y) : 0.0};
  }
  for (PlaneAngle& known : plane_angles_) {
    known.accepted = state.loads.forces.elements[known.element].q;
  }
}

void TurnCounter::anchor(double t, const Configuration& x) {
  accepted_at_ = t;
  for (std::size_t j = 0; j < turns_.size(); ++j) {
    turns_[j] = {x.angles[j], 0.0, 0.0};
  }
}

}  // namespace clevis::mechanism
