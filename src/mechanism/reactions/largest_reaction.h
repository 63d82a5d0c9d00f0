#pragma once

#include "mechanism/definition/motion.h"

namespace clevis::mechanism {

/// Of a motion; moments over a length [N]. @param length  [m].
double largest_reaction(const Motion& motion, double length);

}  // namespace clevis::mechanism
