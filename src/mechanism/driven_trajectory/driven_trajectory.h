#pragma once

#include <list>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "mechanism/driven_motion/driven_motion.h"
#include "mechanism/driven_trajectory/driven_guards.h"
#include "mechanism/sampling/body_loads.h"

namespace clevis::mechanism {

/// A motion that drives fix, evaluated at any time [s] on demand.
class DrivenTrajectory {
 public:
  struct Look {
    double t{};  ///< [s]
    Configuration x;
    Eigen::VectorXd loads;                     ///< of BodyLoads [N], [N m]
    Eigen::VectorXd guards;                    ///< DrivenGuards::values()
    std::vector<std::optional<double>> rates;  ///< DrivenGuards::rates()
    Eigen::VectorXd bend;  ///< of the guards until the next look; DrivenEvents
    std::vector<double> lines;  ///< angles of elements' lines and rates
    double turning{};           ///< fastest body [rad/s]
    bool is_instant = false;    ///< of the motion
    bool breaks = false;        ///< loads jump between it and the next
    bool bends = false;         ///< loads may bend there
    bool repeats = false;       ///< loads between instants of another time
    bool follows = false;       ///< see LoadInstants::follow
    bool is_new = true;         ///< not yet compared with its neighbours
  };
  using Looks = std::list<Look>;
  using At = Looks::iterator;

  DrivenTrajectory(const MechanismDefinition& definition,
                   const SimulationSettings& settings, DrivenMotion& motion);

  /// Looks at increasing times, the first at 0, and between them as often as
  /// bodies turn far.
  /// @param most  looks. @return whether that was enough.
  bool walk(const std::vector<double>& times, std::size_t most);
  /// Between a look and the next one: nothing where J loses rank.
  /// @pre left->t < t < std::next(left)->t.
  std::optional<At> look(At left, double t);
  /// Guards at such a time, without a look.
  Eigen::VectorXd guards_between(At left, double t);
  /// Whether a guard's zero at such a time changes anything.
  bool matters_between(At left, double t, Eigen::Index guard);
  const ForceModel& forces() const { return motion_.instants().forces(); }
  /// Modes of the elements at such a time.
  std::vector<int> modes_between(At left, double t);

  Looks& looks() { return looks_; }
  const Looks& looks() const { return looks_; }
  const BodyLoads& loads() const { return loads_; }
  const DrivenGuards& guards() const { return guards_; }
  long count() const { return count_; }
  double duration() const { return settings_.duration; }
  const std::vector<ChangePoint>& change_points() const {
    return change_points_;
  }

 private:
  Look look_at(const DrivenMoment& moment);
  const DrivenMoment& moment_of(At look);
  DrivenMoment follow(At left, double t);
  ForceState forces_between(At left, double t);
  void turn_often(At left, std::size_t most);

  const SimulationSettings& settings_;
  DrivenMotion& motion_;
  BodyLoads loads_;
  DrivenGuards guards_;
  Looks looks_;
  std::vector<ChangePoint> change_points_;
  std::optional<DrivenMoment> moment_;  ///< of the look that was last asked for
  long count_ = 0;
};

}  // namespace clevis::mechanism
