#pragma once

#include "part/solid_source.h"
#include "scene/text/value.h"

namespace clevis::scene {

/// `faces` of a part: groups of a solid's faces by selectors.
/// @throws Error S002-S006, S010.
std::vector<part::NamedFaces> read_faces(const Value& table);

}  // namespace clevis::scene
