#pragma once

#include "mechanism/definition/definition.h"
#include "part/part_definition.h"
#include "scene/text/names.h"
#include "scene/text/strict_table.h"

namespace clevis::scene {

/// The part's `forces`; those on its body without one are refused when the
/// part is checked.
void read_force_seats(StrictTable& table, mechanism::BodyIndex body,
                      const mechanism::MechanismDefinition& mechanism,
                      const Names& names, part::PartDefinition& part);

}  // namespace clevis::scene
