#pragma once

#include <string>

#include "part/solid_source.h"

namespace clevis::cad {

/// Of all that decides about a solid's mesh beside the file: equal for equal
/// groups and sizes, wherever the scene says them.
std::string text_of(const part::SolidSource& source);

}  // namespace clevis::cad
