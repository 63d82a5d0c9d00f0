#include "machine/bearings/bearing.h"

#include <algorithm>

namespace clevis::machine {

double life_exponent(BearingKind kind) {
  return kind == BearingKind::kBall ? 3.0 : 10.0 / 3.0;
}

const char* name_of(BearingKind kind) {
  return kind == BearingKind::kBall ? "ball" : "roller";
}

double dynamic_equivalent(const BearingDefinition& bearing, double radial,
                          double axial) {
  double load = radial;
  if (const auto& f = bearing.dynamic_factors;
      f && axial > f->threshold * radial) {
    load = f->X * radial + f->Y * axial;
  }
  return bearing.service_factor * load;
}

double static_equivalent(const BearingDefinition& bearing, double radial,
                         double axial) {
  const auto& f = bearing.static_factors;
  return f ? std::max(radial, f->X * radial + f->Y * axial) : radial;
}

}  // namespace clevis::machine
