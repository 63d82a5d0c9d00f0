#include "mechanism/equations_of_motion/projection.h"

#include "mechanism/line_elements/friction.h"

namespace clevis::mechanism {

using Eigen::Index;
using Eigen::VectorXd;

Projection::Projection(EquationsOfMotion& equations)
    : equations_(equations),
      targets_(equations.targets()),
      residual_(VectorXd::Zero(equations.constraints().most_rows())),
      change_(VectorXd::Zero(equations.constraints().columns())) {}

double Projection::project(double t, VectorXd& y) {
  equations_.factor(t, y);
  const double gap = correct_positions(t, y);
  correct_velocities(y);
  equations_.place(t, y);
  return gap;
}

double Projection::correct_positions(double t, VectorXd& y) {
  constexpr int kMost = 4;
  constexpr double kClosed = 1e-13;
  const ConstraintSystem& system = equations_.system();
  const double length = equations_.layout().length();
  MotionConstraints& constraints = equations_.constraints();
  double last = 0.0;
  for (int i = 0;; ++i) {
    const MechanismState& state = equations_.state();
    system.residual(state.placed, equations_.targets().coordinates, residual_);
    residual_.tail(residual_.size() - system.rows()).setZero();
    const double gap =
        residual_.size() == 0 ? 0.0 : residual_.lpNorm<Eigen::Infinity>();
    if (gap <= kClosed * length || i == kMost || (i > 1 && gap > 0.5 * last)) {
      return gap;
    }
    last = gap;
    constraints.mass().correct(residual_, change_);
    equations_.layout().move(y, change_);
    equations_.place(t, y);
    // the factor at hand serves unless the gap was large
    if (gap > 1e-6 * length) constraints.factor(state);
  }
}

/// By the rows where the positions are now; sticking rows hardly turn.
void Projection::correct_velocities(VectorXd& y) {
  const StateLayout& layout = equations_.layout();
  const Index system_rows = equations_.system().rows();
  MotionConstraints& constraints = equations_.constraints();
  const MechanismState& state = equations_.state();
  residual_.head(constraints.rows()).noalias() =
      constraints.with_joint_rows(state.placed) * state.speeds;
  residual_.head(system_rows) -=
      equations_.targets().row_rates.head(system_rows);
  constraints.for_each_element_row([&](std::size_t k, int row) {
    // rotors turn as their joints do
    if (constraints.turns_rotor(k)) residual_[row] = 0.0;
  });
  constraints.mass().correct(residual_, change_);
  y.segment(layout.velocity_index(), layout.velocities()) +=
      change_.head(layout.velocities());
}

void Projection::jump(double t, VectorXd& y) {
  const double before = equations_.kinetic_energy(y);
  ForceModel& forces = equations_.forces();
  for (std::size_t k = 0; k < forces.size(); ++k) {
    if (forces.element(k).is_dry()) forces.element(k).modes[0] = kOmitted;
  }
  project(t, y);
  y[equations_.layout().work_index()] += equations_.kinetic_energy(y) - before;
}

double Projection::gap(double t, const VectorXd& y) {
  const MechanismState& state = equations_.place(t, y);
  equations_.drives().put(t, targets_);
  const int rows = equations_.system().rows();
  if (rows == 0) return 0.0;
  equations_.system().residual(state.placed, targets_.coordinates, residual_);
  return residual_.head(rows).lpNorm<Eigen::Infinity>();
}

}  // namespace clevis::mechanism
