#include "mechanism/equations_of_motion/equations_of_motion.h"

#include "mechanism/equations_of_motion/sticking_shares.h"
#include "mechanism/forces/element_modes.h"
#include "mechanism/forces/given_efforts.h"
#include "mechanism/forces/line_motion.h"

namespace clevis::mechanism {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

MotionSolution no_solution(Index columns, Index rows) {
  return {.forces = VectorXd::Zero(columns),
          .row_accelerations = VectorXd::Zero(rows),
          .accelerations = VectorXd::Zero(columns),
          .multipliers = VectorXd::Zero(rows)};
}

/// Q of the wrenches about the centres of mass, less what turning bodies take.
void put_forces(const StateLayout& layout, const BodyInertias& inertias,
                const MechanismState& state, VectorXd& Q) {
  const std::vector<SpatialForce>& wrenches = state.loads.wrenches;
  const double length = layout.length();
  for (std::size_t i = 1; i < wrenches.size(); ++i) {
    if (layout.is_planar()) {
      const auto at = static_cast<Index>(3 * (i - 1));
      Q.segment<2>(at) = wrenches[i].v.head<2>();
      Q[at + 2] = wrenches[i].w.z() / length;
    } else {
      const auto at = static_cast<Index>(6 * (i - 1));
      const Vector3d& w = state.twists[i].w;
      const Vector3d spin = inertias.spin(i, state.x[i].R, w);
      Q.segment<3>(at) = wrenches[i].v;
      Q.segment<3>(at + 3) = (wrenches[i].w - w.cross(spin)) / length;
    }
  }
}

}  // namespace

EquationsOfMotion::EquationsOfMotion(const MechanismDefinition& definition,
                                     const SolvingFrame& frame)
    : system_(frame, definition.drives,
              frame.planar ? Motions::kInPlane : Motions::kSpatial,
              ConstraintSystem::Drives::kAll),
      loads_(definition, frame),
      layout_(frame, loads_.forces().internal_states()),
      inertias_(definition, frame),
      constraints_(frame, system_, loads_.forces(), inertias_),
      following_(loads_.forces(), system_,
                 static_cast<int>(constraints_.columns()),
                 static_cast<int>(constraints_.most_rows())),
      drives_(definition.drives, system_),
      turns_(frame, layout_, loads_.forces()),
      state_{.x = frame.placement,
             .twists = std::vector<Twist>(frame.placement.size()),
             .placed = system_.place(frame.placement),
             .speeds = VectorXd::Zero(constraints_.columns()),
             .loads = loads_.none()},
      targets_(drives_.none(constraints_.most_rows())),
      solution_(no_solution(constraints_.columns(), constraints_.most_rows())),
      response_(solution_),
      at_rest_(VectorXd::Zero(constraints_.most_rows())) {}

VectorXd EquationsOfMotion::start(const Configuration& x) {
  VectorXd y = VectorXd::Zero(layout_.size());
  layout_.put_positions(x, y);
  forces().start_internal(x, y.data() + layout_.internal_index());
  turns_.start(x, y);
  return y;
}

void EquationsOfMotion::enter_piece(double t) {
  drives_.enter_piece(t);
  forces().enter_piece(t);
}

void EquationsOfMotion::accept(double t, const VectorXd& y) {
  forces().accept(t, state_.loads.forces);
  turns_.accept(t, y, state_);
}

const MechanismState& EquationsOfMotion::place(double t, const VectorXd& y) {
  layout_.read(y, state_);
  inertias_.put_turned_blocks(state_.x, constraints_.mass());
  turns_.count(t, y, state_, forces());
  system_.place(state_.x, state_.placed);
  return state_;
}

const MechanismState& EquationsOfMotion::evaluate_forces(double t,
                                                         const VectorXd& y) {
  place(t, y);
  forces().evaluate(t, state_.x, state_.twists,
                    y.data() + layout_.internal_index(), state_.loads.forces);
  return state_;
}

void EquationsOfMotion::hold_tangents(double t, const VectorXd& y) {
  place(t, y);
  loads_.hold_tangents(t, state_.x, state_.twists,
                       y.data() + layout_.internal_index(), state_.loads);
}

const MechanismState& EquationsOfMotion::factor(double t, const VectorXd& y) {
  place(t, y);
  drives_.put(t, targets_);
  loads_.evaluate(t, state_.x, state_.twists,
                  y.data() + layout_.internal_index(), state_.loads);
  put_forces(layout_, inertias_, state_, solution_.forces);
  constraints_.factor(state_);
  return state_;
}

/// Accelerations that drives ask of rows, less those that velocities cause.
void EquationsOfMotion::put_row_accelerations() {
  VectorXd& gamma = solution_.row_accelerations;
  const Index rows = system_.rows();
  system_.bias(state_.placed, state_.twists, gamma);
  gamma.head(rows) = targets_.row_accelerations.head(rows) - gamma.head(rows);
  constraints_.for_each_element_row([&](std::size_t k, int row) {
    gamma[row] = -constraints_.row_scale(k) *
                 line_bias(forces().element(k), state_.loads.forces.elements[k],
                           state_.twists);
  });
}

const MotionSolution& EquationsOfMotion::solve(double t, const VectorXd& y) {
  factor(t, y);
  put_row_accelerations();
  MotionSolution& s = solution_;
  ForceState& acting = state_.loads.forces;
  ConstrainedMass& mass = constraints_.mass();
  mass.accelerate(s.row_accelerations, s.forces, s.accelerations,
                  s.multipliers);
  if (mass.rank() < constraints_.rows()) {
    share_among_sticking(constraints_, forces(), acting, s.multipliers);
  }
  s.following_power = following_.empty()
                          ? 0.0
                          : following_.solve(forces(), mass, acting,
                                             s.accelerations, s.multipliers);
  constraints_.for_each_element_row([&](std::size_t k, int row) {
    give_row_effort(forces().element(k),
                    constraints_.row_scale(k) * s.multipliers[row],
                    acting.elements[k]);
  });
  return s;
}

const MotionSolution& EquationsOfMotion::respond(const VectorXd& force) {
  constraints_.mass().accelerate(at_rest_, force, response_.accelerations,
                                 response_.multipliers);
  return response_;
}

bool EquationsOfMotion::has_joints_alone() const {
  return following_.empty() && !any_sticks(loads_.forces());
}

double EquationsOfMotion::kinetic_energy(const VectorXd& y) {
  place(turns_.accepted_at(), y);
  double energy = inertias_.kinetic_energy(state_.x, state_.twists);
  for (std::size_t k = 0; k < forces().size(); ++k) {
    if (!constraints_.turns_rotor(k)) continue;
    const ActingElement& e = forces().element(k);
    const double turn = joint_rate(e, state_.placed, state_.twists);
    energy += 0.5 * e.inertia() * turn * turn;
  }
  return energy;
}

}  // namespace clevis::mechanism
