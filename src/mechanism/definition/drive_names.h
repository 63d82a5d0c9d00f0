#pragma once

#include <string>

#include <Eigen/Core>

#include "mechanism/definition/definition.h"

namespace clevis::mechanism {

/// Whether a drive prescribes an angle and takes a torque; else it is a
/// length and a force.
bool drives_angle(const MechanismDefinition& definition,
                  const DriveDefinition& drive);

/// "A", or "A.distance" if it is not the joint's first coordinate.
std::string drive_name(const MechanismDefinition& definition,
                       const DriveDefinition& drive);

/// Coordinates of the drives at time t [s].
Eigen::VectorXd drive_positions(const MechanismDefinition& definition,
                                double t);

/// "crank at 10 deg, cylinder at 3.5 mm". @param targets  by drive [m] or
/// [rad].
std::string drives_at(const MechanismDefinition& definition,
                      const Eigen::VectorXd& targets, int digits);

}  // namespace clevis::mechanism
