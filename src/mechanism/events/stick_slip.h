#pragma once

#include <Eigen/Core>

#include "mechanism/equations_of_motion/forward_dynamics.h"

namespace clevis::mechanism {

/// Which lines of dry friction stick, slip or turn: a complementarity problem.
/// A line at rest sticks while its effort stays below its breakaway effort;
/// where it does not, it slips in the sense of its acceleration. Modes are
/// tried one by one until the equations of motion contradict none. Times t [s].
class StickSlip {
 public:
  explicit StickSlip(ForwardDynamics& dynamics);

  /// Modes of the force elements from the state alone, then resolve_modes().
  /// @throws Error K011 where rigid bodies have no answer.
  void choose_modes(double t, const Eigen::VectorXd& y);
  /// Decides which elements at rest stick, by the forces of the state.
  /// @throws Error K011 where rigid bodies have no answer.
  void resolve_modes(double t, const Eigen::VectorXd& y);
  /// Stops or reverses element k, which has just come to rest. It stops if that
  /// changes no speed beyond the tolerance; a dependent line at a dead centre
  /// reverses.
  void stop_or_reverse(double t, Eigen::VectorXd& y, std::size_t k);
  /// Upper bound of the first step so that Stribeck's zone is resolved [s];
  /// 0: none.
  double first_step(double t, const Eigen::VectorXd& y);

 private:
  void stop_what_hardly_moves();
  bool release_most_loaded();
  bool judge_lines_at_breakaway(double t, const Eigen::VectorXd& y);
  Eigen::VectorXd beginning_of_drives(double t) const;
  bool release_first_of_dependent(double t, const Eigen::VectorXd& y);
  int first_at_breakaway(const Eigen::VectorXd& push, std::size_t& first) const;
  bool is_carried(double t, const Eigen::VectorXd& y, std::size_t k);
  int mode_of_dependent_line(double t, const Eigen::VectorXd& y, std::size_t k);
  bool release_dependent_lines(double t, const Eigen::VectorXd& y);
  double line_acceleration(std::size_t k) const;
  double free_acceleration(std::size_t k) const;
  double acceleration_size() const;
  const ElementResponse& acting(std::size_t k) const {
    return equations_.state().loads.forces.elements[k];
  }

  EquationsOfMotion& equations_;
  MotionConstraints& constraints_;  ///< of the equations
  Projection& projection_;
  const StateScales& scales_;
  ForceModel& forces_;
};

}  // namespace clevis::mechanism
