#pragma once

#include "mechanism/element_base/element_response.h"
#include "mechanism/element_base/mode_switch.h"
#include "mechanism/force_laws/contact_law.h"

namespace clevis::mechanism {

// Ends of an element that press and do not pull: a contact, the ends of a
// stop. Mode of an end: 0 open, 1 pressing, 2 deep but without force.

/// Notes depth, rate and effort of an end. @return its effort in its mode.
double press(const ModeSwitch& e, std::size_t end, const ContactLaw& law,
             double depth, double rate, ElementResponse& now);
/// Of the effort of an end.
/// @param depth, rate  of its penetration [m] or [rad], by the second.
LineTangent contact_tangent(const ContactLaw& law, double depth, double rate);
/// Mode of an end by its depth alone.
int pressing_mode(const ElementResponse& now, std::size_t end,
                  const ContactLaw& law);
/// See ModeSwitch::event_value().
double pressing_value(const ModeSwitch& e, std::size_t end,
                      const ContactLaw& law, const ElementResponse& now);
/// See ModeSwitch::pass_event().
void pass_pressing(ModeSwitch& e, std::size_t end, const ContactLaw& law,
                   const ElementResponse& now);
/// See ModeSwitch::name_of_change().
const char* name_of_pressing(int mode, int mode_before);

/// Guards of an end: touched, fully pressed, and as its own, numbered like the
/// end, without force.
void add_pressing_guards(int end, const ContactLaw& law,
                         std::vector<ElementGuard>& guards);

}  // namespace clevis::mechanism
