#pragma once

#include <optional>
#include <vector>

#include "mechanism/definition/definition.h"
#include "mechanism/definition/motion.h"

namespace clevis::mechanism {

/// Friction on joints that sticks at an instant, as drives: of coordinates that
/// neither joints nor drives fix.
std::vector<DriveDefinition> sticking_coordinates(
    const MechanismDefinition& definition, const Instant& instant);

/// The mechanism with springs in place of force elements that give way slowly
/// by less than they do at once [N/m], [N m/rad]: gas that flows or takes heat,
/// and friction at rest, which breaks away as it gives way by 1/200 rad, the
/// sway that a structure is assumed to have (EN 1993-1-1, 5.3.2), of a slide by
/// 1/200 of the mechanism's length. Absent: there are none.
std::optional<MechanismDefinition> yielding_at_rest(
    const MechanismDefinition& definition, const Instant& instant);

}  // namespace clevis::mechanism
