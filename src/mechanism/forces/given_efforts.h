#pragma once

#include "mechanism/element_base/acting_element.h"

namespace clevis::mechanism {

// Efforts of lines that something else than their laws decides.

/// Whether an element brings a row of its own to the equations of motion: it
/// sticks, or a rotor turns with it.
inline bool brings_row(const ActingElement& e) {
  return e.sticks() || e.inertia() > 0.0;
}
/// Gives a sticking element the effort that holds it. Adds to a motor's effort
/// that of the row of its rotor. @param effort  [N], [N m].
void give_row_effort(const ActingElement& e, double effort,
                     ElementResponse& now);
/// Gives friction that follows a reaction its load [N], and with it, unless it
/// sticks, its effort.
void give_load(const ActingElement& e, double load, ElementResponse& now);

}  // namespace clevis::mechanism
