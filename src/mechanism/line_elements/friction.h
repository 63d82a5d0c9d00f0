#pragma once

#include <memory>

#include "mechanism/element_base/element_properties.h"
#include "mechanism/element_base/force_line.h"
#include "mechanism/force_laws/friction_law.h"

namespace clevis::mechanism {

class ActingElement;
struct ReferenceFrame;

/// Mode of friction that is left out: for a moment, or at rest while joints and
/// drives alone carry its line. The others: 0 sticks, ±1 slips in that sense,
/// ±2 gives its most against that sense while other friction still holds the
/// line. The second mode tells whether it is in Stribeck's zone.
inline constexpr int kOmitted = 3;

ElementProperties properties(const FrictionLaw& law);
/// @param law  outlives the result.
std::unique_ptr<ActingElement> place(const LineDefinition& definition,
                                     const FrictionLaw& law,
                                     const ReferenceFrame& frame);

}  // namespace clevis::mechanism
