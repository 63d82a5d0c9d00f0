#include "mechanism/definition/drive_names.h"

#include <numbers>

#include <fmt/format.h>

#include "mechanism/drives/drive_law.h"
#include "mechanism/joints/joint_types.h"

namespace clevis::mechanism {

using Eigen::Index;
using Eigen::VectorXd;

bool drives_angle(const MechanismDefinition& definition,
                  const DriveDefinition& drive) {
  const auto joint = static_cast<std::size_t>(drive.joint);
  return coordinate_row(definition.joints[joint].type, drive.coordinate)
      .is_angle();
}

std::string drive_name(const MechanismDefinition& definition,
                       const DriveDefinition& drive) {
  const JointDefinition& joint =
      definition.joints[static_cast<std::size_t>(drive.joint)];
  if (drive.coordinate == 0) return joint.name;
  const auto k = static_cast<std::size_t>(drive.coordinate);
  return joint.name + "." + std::string(coordinates(joint.type)[k].name);
}

VectorXd drive_positions(const MechanismDefinition& definition, double t) {
  VectorXd q(static_cast<Index>(definition.drives.size()));
  for (Index i = 0; i < q.size(); ++i) {
    q[i] = drive_target(definition.drives[static_cast<std::size_t>(i)], t)
               .position;
  }
  return q;
}

std::string drives_at(const MechanismDefinition& definition,
                      const VectorXd& targets, int digits) {
  std::string text;
  for (std::size_t i = 0; i < definition.drives.size(); ++i) {
    const DriveDefinition& drive = definition.drives[i];
    const std::string name = drive_name(definition, drive);
    const double q = targets[static_cast<Eigen::Index>(i)];
    text += text.empty() ? "" : ", ";
    text += drives_angle(definition, drive)
                ? fmt::format("{} at {:.{}g} deg", name,
                              q * 180.0 / std::numbers::pi, digits)
                : fmt::format("{} at {:.{}g} mm", name, 1e3 * q, digits);
  }
  return text;
}

}  // namespace clevis::mechanism
