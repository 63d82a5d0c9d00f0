#pragma once

#include "mechanism/definition/definition.h"
#include "part/part_definition.h"
#include "part/solid_source.h"
#include "scene/text/names.h"
#include "scene/text/strict_table.h"

namespace clevis::scene {

/// The part's `pins`, `drives` and `forces`, checked against the body that it
/// moves with: each of the body's joints and drives needs its seat. Joints of a
/// solid find their own where `pins` is left out or says "auto".
void read_seats(StrictTable& table,
                const mechanism::MechanismDefinition& mechanism,
                const Names& names, part::PartDefinition& part,
                part::SolidSource& solid);

}  // namespace clevis::scene
