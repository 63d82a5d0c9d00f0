#include "mechanism/forces/force_state.h"

#include <algorithm>

namespace clevis::mechanism {

void put_internal_rates(const ForceState& state, double* rates) {
  for (const ElementResponse& e : state.elements) {
    rates = std::ranges::copy(e.internal_rates, rates).out;
  }
}

}  // namespace clevis::mechanism
