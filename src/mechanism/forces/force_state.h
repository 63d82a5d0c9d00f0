#pragma once

#include <vector>

#include "mechanism/element_base/element_response.h"

namespace clevis::mechanism {

/// Responses of all force elements of a mechanism in one state of a motion
/// (SI).
struct ForceState {
  std::vector<ElementResponse> elements;  ///< by force element
};

/// Rates of the internal states, one element's behind the other's (SI).
void put_internal_rates(const ForceState& state, double* rates);

}  // namespace clevis::mechanism
