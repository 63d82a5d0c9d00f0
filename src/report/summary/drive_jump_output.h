#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "mechanism/definition/definition.h"
#include "mechanism/definition/motion.h"

namespace clevis::report {

/// A DriveJump with the name of what is driven.
struct NamedDriveJump {
  std::string drive;
  bool turns{};
  double at{};                ///< [s]
  double before{}, behind{};  ///< [m/s] or [rad/s]
};

std::vector<NamedDriveJump> named_drive_jumps(
    const mechanism::MechanismDefinition& definition,
    const mechanism::Motion& motion);

/// A line of a table each, with what it means; empty without jumps.
std::string drive_jump_lines(const std::vector<NamedDriveJump>& jumps);

/// drive, at_s, before_… and behind_…, in rad/s or m/s.
nlohmann::ordered_json drive_jumps_json(
    const std::vector<NamedDriveJump>& jumps);

}  // namespace clevis::report
