#pragma once

#include <Eigen/Core>

#include "mechanism/definition/time_limit.h"
#include "mechanism/dynamic_motion/dynamic_change_points.h"
#include "mechanism/integration/dynamic_model.h"
#include "mechanism/integration/motion_integrator.h"

namespace clevis::mechanism {

/// Guards that end an integrated motion early. Times [s].
class MotionGuards {
 public:
  /// @param model, change_points, integrator  of the run; outlive this, as does
  ///   limit.
  MotionGuards(DynamicModel& model, const DynamicChangePoints& change_points,
               const MotionIntegrator& integrator, TimeLimit& limit)
      : model_(model),
        change_points_(change_points),
        integrator_(integrator),
        limit_(limit) {}

  /// Notes an event. @return whether too many follow one another too closely.
  bool are_events_crowded(double t);
  /// @throws Error K008, always.
  [[noreturn]] void refuse_crowded_events(double t);
  /// The integrator found no step short enough. @throws Error K008, or for
  ///   its reason K004 or K011; always.
  [[noreturn]] void refuse_stuck();
  /// Where what drives go on to do meets rows that fade, no position leads on.
  /// @throws Error K004 there.
  void refuse_dead_end();
  /// @param gap  of joints and drives at t [m]. @throws Error K012, or K004 for
  ///   its reason.
  void require_closed(double t, double gap);
  /// Friction at rest holds, friction that slips resists.
  /// @param y  at the end of the integrator's step. @throws Error K012.
  void require_resisting_friction(const Eigen::VectorXd& y);
  /// A motion that takes too long, or would, is refused with what keeps its
  /// steps short. @throws Error K013.
  void require_in_time();

 private:
  struct WeakestRows {
    bool beside = false;  ///< a change point
    Eigen::VectorXd row;  ///< combination of J's rows, of length 1
  };
  WeakestRows weakest_rows();

  DynamicModel& model_;
  const DynamicChangePoints& change_points_;
  const MotionIntegrator& integrator_;
  TimeLimit& limit_;
  long steps_ = 0;
  int crowded_events_ = 0;
  double last_event_ = -1.0;
};

}  // namespace clevis::mechanism
