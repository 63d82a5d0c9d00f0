#pragma once

#include <vector>

#include "mechanism/definition/definition.h"
#include "scene/text/names.h"
#include "scene/text/strict_table.h"

namespace clevis::scene {

/// The [[body]] tables; a body may name a part.
/// @throws Error S002–S011, K006 without mass.
std::vector<mechanism::BodyDefinition> read_bodies(StrictTable& root,
                                                   Names& names);

/// Index of a body, kGround for "ground". @throws Error S005, S007.
mechanism::BodyIndex find_body_or_ground(const Value& name, const Names& names);

}  // namespace clevis::scene
