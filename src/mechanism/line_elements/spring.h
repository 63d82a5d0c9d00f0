#pragma once

#include <memory>

#include "mechanism/element_base/element_properties.h"
#include "mechanism/element_base/force_line.h"

namespace clevis::mechanism {

class ActingElement;
struct ReferenceFrame;

/// Effort on b: −stiffness (q − free) − damping q' − preload; > 0 pushes apart.
struct SpringLaw {
  double stiffness{};  ///< [N/m] or [N m/rad]
  double damping{};    ///< [N s/m] or [N m s/rad]
  double free{};       ///< [m] or [rad]
  double preload{};    ///< pull at the free length [N] or [N m]
};

ElementProperties properties(const SpringLaw& law);
/// @param law  outlives the result.
std::unique_ptr<ActingElement> place(const LineDefinition& definition,
                                     const SpringLaw& law,
                                     const ReferenceFrame& frame);

}  // namespace clevis::mechanism
