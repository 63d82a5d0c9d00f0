#pragma once

#include <vector>

#include <Eigen/Core>

#include "mechanism/constraints/constraint_system.h"
#include "mechanism/drives/drive_law.h"

namespace clevis::mechanism {

/// Targets of drives at a time: coordinates [m] or [rad], and by row of a
/// ConstraintSystem rates [m/s] and accelerations [m/s²], turns × length.
struct DriveTargets {
  Eigen::VectorXd coordinates;        ///< by drive
  Eigen::VectorXd row_rates;          ///< 0 in rows of joints
  Eigen::VectorXd row_accelerations;  ///< likewise
};

/// The laws of a mechanism's drives piece by piece, as an integration follows
/// them. Times [s].
class DriveSchedule {
 public:
  /// @param drives, system  outlive this.
  DriveSchedule(const std::vector<DriveDefinition>& drives,
                const ConstraintSystem& system)
      : drives_(drives), system_(system) {}

  const std::vector<DriveDefinition>& drives() const { return drives_; }
  /// Drives follow from now on, at t itself too, what their laws say behind a
  /// bend at t.
  void enter_piece(double t) { piece_start_ = t; }
  /// Coordinate, rate and acceleration of drive k at t [m], [m/s], [m/s²] or
  /// [rad], [rad/s], [rad/s²].
  DriveTarget target(std::size_t k, double t) const;
  /// No targets. @param rows  at least those of the system.
  DriveTargets none(Eigen::Index rows) const;
  /// Fills in those of a time [s]; does not allocate.
  void put(double t, DriveTargets& targets) const;
  /// Adds the power [W] by multipliers of the rows [N] to that of others [W].
  double add_power(const DriveTargets& targets,
                   const Eigen::VectorXd& multipliers, double others) const;

 private:
  const std::vector<DriveDefinition>& drives_;
  const ConstraintSystem& system_;
  double piece_start_{};  ///< of the laws [s]
};

}  // namespace clevis::mechanism
