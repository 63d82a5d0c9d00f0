#include "mechanism/dynamic_state/drive_schedule.h"

#include "base/values/index.h"

namespace clevis::mechanism {

using Eigen::Index;
using Eigen::VectorXd;

DriveTarget DriveSchedule::target(std::size_t k, double t) const {
  const BreakpointSide side =
      t > piece_start_ ? BreakpointSide::kBefore : BreakpointSide::kBehind;
  return drive_target(drives_[k], t, side);
}

DriveTargets DriveSchedule::none(Index rows) const {
  const auto count = static_cast<Index>(drives_.size());
  return {VectorXd::Zero(count), VectorXd::Zero(rows), VectorXd::Zero(rows)};
}

void DriveSchedule::put(double t, DriveTargets& targets) const {
  for (std::size_t k = 0; k < drives_.size(); ++k) {
    const DriveTarget at = target(k, t);
    const Index row = system_.joint_rows() + static_cast<Index>(k);
    const double scale = system_.scale(system_.row_list()[index(row)]);
    targets.coordinates[static_cast<Index>(k)] = at.position;
    targets.row_rates[row] = scale * at.rate;
    targets.row_accelerations[row] = scale * at.acceleration;
  }
}

double DriveSchedule::add_power(const DriveTargets& targets,
                                const VectorXd& multipliers,
                                double others) const {
  double power = others;
  for (Index i = system_.joint_rows(); i < system_.rows(); ++i) {
    power += multipliers[i] * targets.row_rates[i];
  }
  return power;
}

}  // namespace clevis::mechanism
