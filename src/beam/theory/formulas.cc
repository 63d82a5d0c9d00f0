#include "beam/theory/formulas.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace clevis::beam {

double euler_load(double youngs_modulus, double second_moment, double length) {
  assert(length > 0.0);
  return std::numbers::pi * std::numbers::pi * youngs_modulus * second_moment /
         (length * length);
}

double lame_equivalent_stress(double pressure, double inner, double outer) {
  assert(outer > inner);
  const double a = inner * inner, b = outer * outer;
  const double hoop = pressure * (b + a) / (b - a);
  const double radial = -pressure;
  return std::sqrt(hoop * hoop + radial * radial - hoop * radial);
}

double equivalent_stress(double normal, double shear) {
  return std::sqrt(normal * normal + 3.0 * shear * shear);
}

}  // namespace clevis::beam
