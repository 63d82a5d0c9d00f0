#pragma once

#include "mechanism/force_elements/force_element.h"

namespace clevis::mechanism {

/// Friction at rest over that which slides, where the one falls to the other at
/// once; infinite: none slides. 1 of all else [1].
double sudden_breakaway(const ForceElement& element);

}  // namespace clevis::mechanism
