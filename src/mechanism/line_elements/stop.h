#pragma once

#include <memory>
#include <optional>

#include "mechanism/element_base/element_properties.h"
#include "mechanism/element_base/force_line.h"
#include "mechanism/force_laws/contact_law.h"

namespace clevis::mechanism {

class ActingElement;
struct ReferenceFrame;

/// Unilateral springs at the ends of a line's range.
struct StopLaw {
  std::optional<double> lower, upper;  ///< [m] or [rad]
  ContactLaw contact;
};

ElementProperties properties(const StopLaw& law);
/// @param law  outlives the result.
std::unique_ptr<ActingElement> place(const LineDefinition& definition,
                                     const StopLaw& law,
                                     const ReferenceFrame& frame);

}  // namespace clevis::mechanism
