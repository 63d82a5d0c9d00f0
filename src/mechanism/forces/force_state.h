#pragma once

#include <vector>

#include "mechanism/element_base/element_response.h"

namespace clevis::mechanism {

/// What all force elements of a mechanism do in one state of a motion. Values
/// in SI, those of elements in units of their own.
struct ForceState {
  std::vector<ElementResponse> elements;  ///< by force element
};

/// Rates of the internal states, one element's behind the other's (SI).
void put_internal_rates(const ForceState& state, double* rates);

}  // namespace clevis::mechanism
