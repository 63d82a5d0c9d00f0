#pragma once

#include "scene/element_base/line_source.h"

namespace clevis::scene {

/// `model`, stiffness and damping of what presses. @throws Error S002–S011.
mechanism::ContactLaw read_contact_law(StrictTable& table,
                                       const LineUnits& units);

}  // namespace clevis::scene
