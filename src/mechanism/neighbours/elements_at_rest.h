#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "mechanism/definition/definition.h"
#include "mechanism/definition/motion.h"
#include "mechanism/neighbours/neighbours.h"

namespace clevis::mechanism {

/// Friction that sticks at an instant, where neither joints nor drives nor
/// other friction hold already.
struct Sticking {
  std::vector<DriveDefinition> coordinates;  ///< of joints
  std::vector<std::size_t> lines;            ///< force elements between points
};

Sticking sticking(const MechanismDefinition& definition,
                  const Instant& instant);

/// Of a force element's two bodies, held by nothing else, on the stiffness that
/// it has [s]; infinite where it has none.
double free_period(const Neighbours& neighbours, std::size_t element,
                   const Instant& instant);

/// The mechanism with springs in place of force elements that give way slowly
/// by less than they do at once [N/m], [N m/rad]: gas that flows or takes heat,
/// and friction at rest, which breaks away as it gives way by 1/200 rad, the
/// sway that a structure is assumed to have (EN 1993-1-1, 5.3.2), of a slide by
/// 1/200 of the mechanism's length. Absent: there are none.
std::optional<MechanismDefinition> yielding_at_rest(
    const MechanismDefinition& definition, const Instant& instant);

}  // namespace clevis::mechanism
