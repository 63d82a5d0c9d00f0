#pragma once

#include <vector>

#include "assessment/job/part_job.h"
#include "mechanism/definition/definition.h"
#include "mechanism/definition/motion.h"

namespace clevis::app {

/// The part's blows, those of a contact with mass, speed and force of its
/// hardest impact.
/// @throws Error L006 if the contact is never touched or neither side of it
///   can give way, S010 if it turns, M003 for an unknown group.
std::vector<assessment::ImpactJob> impact_jobs(
    const mechanism::MechanismDefinition& definition,
    const mechanism::Motion& motion, const part::PartDefinition& part,
    const std::vector<loads::GroupGeometry>& groups);

/// The hardest impact of each contact and end of a stop, but those below a
/// hundredth of the hardest of all; of a driven motion, which has no record of
/// impacts, by the forces at its instants.
std::vector<assessment::ImpactLoad> impact_loads(
    const mechanism::MechanismDefinition& definition,
    const mechanism::Motion& motion);

}  // namespace clevis::app
