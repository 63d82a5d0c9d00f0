#pragma once

#include <functional>

#include <Eigen/Core>

#include "mechanism/driven_trajectory/driven_trajectory.h"

namespace clevis::mechanism {

/// What the loads of a driven motion are measured by: the largest that each is
/// seen to be. Beside change points rigid reactions have no largest.
class LoadScales {
 public:
  /// @param beside  whether a time is beside a change point [s].
  /// Both outlive this.
  LoadScales(DrivenTrajectory& trajectory, std::function<bool(double)> beside);

  void note(const DrivenTrajectory::Look& look);
  /// Sets the scales by all looks.
  void update();

  /// By vector of loads() [N], [N m]; 0: it never is any.
  const Eigen::VectorXd& scales() const { return scales_; }
  /// 1 / scale, by number.
  const Eigen::VectorXd& inverse() const { return inverse_; }
  bool beside(double t) const { return beside_(t); }
  DrivenTrajectory& trajectory() const { return trajectory_; }
  const BodyLoads& loads() const { return trajectory_.loads(); }

 private:
  DrivenTrajectory& trajectory_;
  std::function<bool(double)> beside_;
  Eigen::VectorXd largest_, scales_, inverse_;
};

}  // namespace clevis::mechanism
