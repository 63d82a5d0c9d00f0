#include "mechanism/simulate.h"

#include <optional>
#include <utility>

#include <fmt/format.h>

#include "base/messages/errors.h"
#include "mechanism/constraints/closed_joints.h"
#include "mechanism/constraints/mobility.h"
#include "mechanism/definition/drive_names.h"
#include "mechanism/driven_search/driven_run.h"
#include "mechanism/drives/drive_law.h"
#include "mechanism/dynamic_motion/dynamic_motion.h"
#include "mechanism/forces/force_model.h"
#include "mechanism/joints/joint_types.h"
#include "mechanism/reactions/body_motion.h"
#include "mechanism/reactions/other_sharings.h"
#include "mechanism/reactions/unshared_strains.h"

namespace clevis::mechanism {
namespace {

void require_mass(const MechanismDefinition& definition) {
  for (const BodyDefinition& body : definition.bodies) {
    if (body.mass_properties.mass > 0.0) continue;
    throw Error("K006", body.place,
                fmt::format("body {} has a mass of {} kg", body.name,
                            body.mass_properties.mass),
                "Give the body a mass, center_of_mass and inertia, or a part.");
  }
}

/// @throws Error K002 if a force has states that no drive fixes.
void refuse_history(const MechanismDefinition& definition,
                    const ForceModel& forces) {
  for (std::size_t k = 0; k < forces.size(); ++k) {
    if (forces.element(k).internal < 0) continue;
    throw Error("K002", "mechanism",
                fmt::format("force {} has a history of its own, which drives "
                            "do not fix",
                            name_of(definition.elements[k])),
                "Choose motion = \"dynamic\", or leave the key out.");
  }
}

/// An effort between two points that coincide at the start has no direction.
void require_direction(const MechanismDefinition& definition, double length,
                       const Motion& motion) {
  constexpr double kCoincide = 1e-9;  // of the links' length
  if (motion.instants.empty()) return;
  const Instant& start = motion.instants.front();
  for (std::size_t k = 0; k < definition.elements.size(); ++k) {
    const ElementLine* line = line_of(definition.elements[k]);
    if (line == nullptr || line->kind != ElementLine::Kind::kDistance) {
      continue;
    }
    const ElementState& state = start.elements[k];
    if (state.position > kCoincide * length || state.effort == 0.0) continue;
    throw Error("S011", place_of(definition.elements[k]),
                fmt::format("force \"{}\" has {:.4g} N between two points that "
                            "coincide at the start: no direction to act along",
                            name_of(definition.elements[k]), state.effort),
                "Move one of its points, or give it an axis.");
  }
}

/// Coordinates that the drives of a motion that may be either leave free, so
/// that it is integrated; nothing if they fix it.
std::optional<LeftFree> left_free(const MechanismDefinition& definition,
                                  const SolvingFrame& frame,
                                  const SimulationSettings& settings) {
  // bristles and gas have a history of their own
  const ForceModel forces(definition, frame);
  if (settings.motion == MotionKind::kDriven) {
    refuse_history(definition, forces);
    return std::nullopt;
  }
  const ConstraintSystem system(
      frame, definition.drives,
      frame.planar ? Motions::kInPlane : Motions::kSpatial,
      ConstraintSystem::Drives::kAll);
  const Mobility freedom = mobility(
      frame, system,
      closed_joints(definition, frame, settings.tolerance * frame.length));
  const bool is_free =
      freedom.with_drives > 0 && freedom.dependent_drives.empty();
  if (!is_free && forces.internal_states() == 0) return std::nullopt;
  LeftFree result;
  if (!is_free) return result;
  result.freedom = freedom.with_drives;
  for (const DriveDefinition& coordinate : freedom.free_coordinates) {
    result.coordinates.push_back(drive_name(definition, coordinate));
  }
  return result;
}

}  // namespace

Motion simulate(const MechanismDefinition& definition,
                const SimulationSettings& settings) {
  require_mass(definition);
  const SolvingFrame frame(definition);
  std::optional<LeftFree> free;
  if (settings.motion != MotionKind::kDynamic) {
    free = left_free(definition, frame, settings);
  }
  const bool is_dynamic = free || settings.motion == MotionKind::kDynamic;
  Motion motion = is_dynamic ? integrate_motion(definition, settings)
                             : run_driven(definition, settings);
  motion.left_free = std::move(free);
  refer_to_given_frames(definition, motion);
  require_direction(definition, frame.length, motion);
  motion.unshared = unshared_strains(definition, motion, frame.length);
  forget_negligible(definition.joints, frame.length, motion);
  motion.drive_jumps = drive_jumps(definition.drives, settings.duration);
  return motion;
}

}  // namespace clevis::mechanism
