#include "report/summary/mechanism_summary.h"

#include <algorithm>
#include <cmath>

#include "mechanism/definition/drive_names.h"
#include "mechanism/joints/joint_types.h"
#include "report/notes/motion_notes.h"

namespace clevis::report {
namespace {

template <typename Value>
Peak peak_over(const mechanism::Motion& motion, Value value) {
  Peak peak;
  for (const mechanism::Instant& instant : motion.instants) {
    const double here = value(instant);
    if (here > peak.value) peak = {here, instant.t};
  }
  return peak;
}

void add_open_components(MechanismSummary& summary, std::size_t joint,
                         const std::string& name,
                         const mechanism::Motion& motion) {
  static constexpr const char* kNames[] = {"force x",  "force y",  "force z",
                                           "moment x", "moment y", "moment z"};
  for (std::size_t k = 0; k < 6; ++k) {
    OpenComponent open{.joint = name,
                       .component = kNames[k],
                       .is_moment = k >= 3,
                       .peak = {.value = -1.0}};
    for (const mechanism::Instant& instant : motion.instants) {
      const auto& reaction = instant.joints[joint];
      if (reaction.unique_components[k]) continue;
      const double here = std::abs(reaction.components()[static_cast<int>(k)]);
      if (!(here > open.peak.value)) continue;
      open.peak = {here, instant.t};
      open.spread = reaction.spread[k];
    }
    if (open.peak.value >= 0.0) summary.open_components.push_back(open);
  }
}

PassedChangePoint passed(const mechanism::MechanismDefinition& definition,
                         const mechanism::ChangePoint& point) {
  PassedChangePoint result{.at = point.t, .joint = {}};
  if (!point.at) return result;
  const auto& joints = point.at->joints;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const double force = joints[j].f_W.norm();
    if (!result.joint.empty() && force <= result.largest_force) continue;
    result.largest_force = force;
    result.joint = definition.joints[j].name;
  }
  return result;
}

}  // namespace

MechanismSummary summarise(const mechanism::MechanismDefinition& definition,
                           const mechanism::Structure& structure,
                           const mechanism::Motion& motion) {
  using mechanism::Instant;
  MechanismSummary summary;
  summary.mobility = structure.mobility;
  summary.redundant_constraints = structure.redundant;
  summary.instants = static_cast<int>(motion.instants.size());
  for (const Instant& instant : motion.instants) {
    summary.max_closure_error =
        std::max(summary.max_closure_error, instant.closure_error);
    summary.max_power_balance_error =
        std::max(summary.max_power_balance_error, instant.power_balance_error);
    summary.instants_left_out += instant.is_change_point ? 1 : 0;
  }
  summary.notes = motion_notes(definition, motion);
  summary.impacts = named_impacts(definition, motion);
  summary.drive_jumps = named_drive_jumps(definition, motion);
  for (const auto& point : motion.change_points) {
    summary.change_points.push_back(passed(definition, point));
  }
  for (std::size_t j = 0; j < definition.joints.size(); ++j) {
    const auto force = [j](const Instant& instant) {
      return instant.joints[j].f_W.norm();
    };
    const auto moment = [j](const Instant& instant) {
      return instant.joints[j].t_W.norm();
    };
    if (std::ranges::any_of(motion.instants, [j](const Instant& instant) {
          return !instant.joints[j].unique;
        })) {
      summary.not_unique.push_back(definition.joints[j].name);
      add_open_components(summary, j, definition.joints[j].name, motion);
    }
    summary.joints.push_back({definition.joints[j].name,
                              peak_over(motion, force),
                              peak_over(motion, moment)});
  }
  for (std::size_t d = 0; d < definition.drives.size(); ++d) {
    const bool turns =
        mechanism::drives_angle(definition, definition.drives[d]);
    const auto effort = [d](const Instant& instant) {
      return std::abs(instant.drives[d].effort);
    };
    summary.drives.push_back({drive_name(definition, definition.drives[d]),
                              turns ? EffortKind::kTorque : EffortKind::kForce,
                              peak_over(motion, effort)});
  }
  return summary;
}

}  // namespace clevis::report
