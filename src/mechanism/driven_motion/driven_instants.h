#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "mechanism/change_points/singular_position.h"
#include "mechanism/definition/motion.h"
#include "mechanism/driven_motion/driven_model.h"
#include "mechanism/forces/force_model.h"

namespace clevis::mechanism {

/// Motion and forces of a mechanism that drives move, from instant to instant:
/// force elements keep their modes and turns between them. Times [s].
class DrivenInstants {
 public:
  /// @param model  outlives this.
  explicit DrivenInstants(const DrivenModel& model)
      : model_(model), forces_(model.definition, model.frame) {}

  /// An instant and the responses of the force elements there.
  struct Acted {
    Instant instant;
    ForceState forces;
  };
  /// At a regular configuration.
  Acted act_at(const ClosedConfiguration& at, double t);
  Instant regular(const ClosedConfiguration& at, double t) {
    return act_at(at, t).instant;
  }
  /// At a change point, with the forces of joints that give way.
  /// @param along  velocity of the unknowns [m/s], or a direction of it [1], on
  ///   the branch. @return nothing where no regular branch goes there.
  std::optional<Instant> singular(const Configuration& x,
                                  const Eigen::VectorXd& along, double t);
  /// Responses of the force elements alone at a moment; from there turns are
  /// counted.
  ForceState sense(const DrivenMoment& moment);

  const ForceModel& forces() const { return forces_; }
  /// Modes that a state of the elements suggests; they take them.
  std::vector<int> choose_modes(const ForceState& state);
  /// Angles [rad] and rates [rad/s] of the elements' lines from which turns are
  /// counted: those of the last instant or sense().
  std::vector<double> line_angles() const;
  void set_line_angles(const std::vector<double>& lines, double t);

 private:
  /// Velocities and accelerations of M by slot.
  struct Rates {
    std::vector<Twist> twists, accelerations;
  };
  Rates rates(const ClosedConfiguration& at, double t) const;
  std::optional<Rates> branch_rates(const BranchPoint& point,
                                    const Eigen::VectorXd& along,
                                    double t) const;
  Instant kinematics(const ClosedConfiguration& at, double t,
                     const Rates& rates) const;
  ForceState act(const ClosedConfiguration& at, double t, const Rates& rates);

  const DrivenModel& model_;
  ForceModel forces_;
};

}  // namespace clevis::mechanism
