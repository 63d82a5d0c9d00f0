#pragma once

#include <memory>
#include <vector>

#include "mechanism/element_base/element_properties.h"
#include "mechanism/element_base/force_line.h"

namespace clevis::mechanism {

class ActingElement;
struct ReferenceFrame;

/// Effort over time, or over the line's coordinate, linear between the points,
/// constant outside. Two equal times: a step, the later effort from then on.
struct TableLaw {
  std::vector<double> times, efforts;
  std::vector<double> positions{};  ///< [m] or [rad]; then no times
};

ElementProperties properties(const TableLaw& law);
/// @param law  outlives the result.
std::unique_ptr<ActingElement> place(const LineDefinition& definition,
                                     const TableLaw& law,
                                     const ReferenceFrame& frame);

}  // namespace clevis::mechanism
