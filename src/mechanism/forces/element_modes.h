#pragma once

#include "mechanism/forces/acting_element.h"

namespace clevis::mechanism {

/// Whether friction holds the line, as a constraint.
bool sticks(const ActingElement& e);

/// Speed below which Stribeck's term of friction counts, of a contact the peak
/// about its critical speed; 0 without one. A step that passes it must be
/// short, as nothing else tells of a peak so narrow.
double stribeck_zone(const ActingElement& e);

/// Sets the modes that the state alone suggests; friction at rest sticks.
void choose_modes(ActingElement& e);

/// Function that is positive while mode `end` (0 or 1) holds, as of
/// evaluate(); 1 where nothing can change.
double event_value(const ActingElement& e, int end);
/// Whether it has modes to change between.
bool may_switch(const ForceElement& definition);

/// Goes on to the mode that follows after event_value() has reached zero.
/// That friction whose speed vanishes sticks is a guess: the caller judges.
void pass_event(ActingElement& e, int end);

/// "press", "release", "stick", "slip", "turn": what the change to the
/// present mode of an end was; null if there was none to speak of.
const char* name_of_change(const ActingElement& e, int end, int mode_before);

}  // namespace clevis::mechanism
