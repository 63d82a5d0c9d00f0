#include "report/summary/drive_jump_output.h"

#include <fmt/format.h>

#include "mechanism/definition/drive_names.h"
#include "mechanism/joints/joint_types.h"
#include "report/text/terminal.h"

namespace clevis::report {

std::vector<NamedDriveJump> named_drive_jumps(
    const mechanism::MechanismDefinition& definition,
    const mechanism::Motion& motion) {
  std::vector<NamedDriveJump> jumps;
  for (const mechanism::DriveJump& jump : motion.drive_jumps) {
    const auto& drive = definition.drives[static_cast<std::size_t>(jump.drive)];
    jumps.push_back({.drive = mechanism::drive_name(definition, drive),
                     .turns = mechanism::drives_angle(definition, drive),
                     .at = jump.t,
                     .before = jump.before,
                     .behind = jump.behind});
  }
  return jumps;
}

std::string drive_jump_lines(const std::vector<NamedDriveJump>& jumps) {
  if (jumps.empty()) return "";
  std::string text;
  for (const NamedDriveJump& jump : jumps) {
    text +=
        fmt::format("  drive {} jumps from {:.4g} to {:.4g} {} at {:.8g} s\n",
                    printable(jump.drive), jump.before, jump.behind,
                    jump.turns ? "rad/s" : "m/s", jump.at);
  }
  return text +
         "  a jump takes an impulse, which no load tells: let the drive's law "
         "start and end gently (quintic)\n";
}

nlohmann::ordered_json drive_jumps_json(
    const std::vector<NamedDriveJump>& jumps) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const NamedDriveJump& jump : jumps) {
    const char* unit = jump.turns ? "rad_per_s" : "m_per_s";
    json.push_back({{"drive", jump.drive},
                    {"at_s", jump.at},
                    {fmt::format("before_{}", unit), jump.before},
                    {fmt::format("behind_{}", unit), jump.behind}});
  }
  return json;
}

}  // namespace clevis::report
