#pragma once

#include <cstddef>
#include <vector>

#include "mechanism/definition/motion.h"
#include "mechanism/neighbours/neighbours.h"

namespace clevis::loads {

/// Whether a force element, if it presses at all, does not at an instant.
bool lets_go(const mechanism::Instant& instant, std::size_t element);

/// Instants at which a contact or a stop bounces: it presses, but not through
/// ten periods of the bodies by themselves on its stiffness. A bounce takes
/// half of one: it is a force, and holds nothing.
/// @param neighbours  of any body. @param instants  of the motion, in order.
std::vector<std::size_t> bounces(
    const mechanism::Neighbours& neighbours, std::size_t element,
    const std::vector<const mechanism::Instant*>& instants);

}  // namespace clevis::loads
