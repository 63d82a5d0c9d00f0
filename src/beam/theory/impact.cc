#include "beam/theory/impact.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace clevis::beam {
namespace {

/// Part of the blow's kinetic energy that is left once the bar moves along.
double kept_energy(const StruckBar& bar, const Blow& blow,
                   StruckMass struck_mass) {
  if (struck_mass == StruckMass::kLeftOut) return 1.0;
  return blow.mass / (blow.mass + bar.mass_part * bar.mass);
}

}  // namespace

BarSection round_section(double diameter) {
  constexpr double kPi = std::numbers::pi;
  const double r = 0.5 * diameter;
  return {.area = kPi * r * r,
          .second_moment = 0.25 * kPi * std::pow(r, 4),
          .section_modulus = 0.25 * kPi * std::pow(r, 3)};
}

StruckBar cantilever(const part::Material& material, const BarSection& section,
                     double length, Formula deflection) {
  const double factor = deflection == Formula::kPublished ? 1.0 : 3.0;
  return {.stiffness = factor * material.youngs_modulus *
                       section.second_moment / std::pow(length, 3),
          .stress_per_force = length / section.section_modulus,
          .mass = material.density * section.area * length,
          .mass_part = 33.0 / 140.0};
}

StruckBar simple_beam(const part::Material& material, const BarSection& section,
                      double length) {
  return {.stiffness = 48.0 * material.youngs_modulus * section.second_moment /
                       std::pow(length, 3),
          .stress_per_force = 0.25 * length / section.section_modulus,
          .mass = material.density * section.area * length,
          .mass_part = 17.0 / 35.0};
}

StruckBar rod(const part::Material& material, const BarSection& section,
              double length) {
  return {.stiffness = material.youngs_modulus * section.area / length,
          .stress_per_force = 1.0 / section.area,
          .mass = material.density * section.area * length,
          .mass_part = 1.0 / 3.0};
}

BarImpact impact(const StruckBar& bar, const Blow& blow,
                 StruckMass struck_mass) {
  assert(bar.stiffness > 0.0 && blow.mass > 0.0);
  const double at_rest = blow.force / bar.stiffness;
  const double energy =
      kept_energy(bar, blow, struck_mass) * blow.mass * blow.speed * blow.speed;
  BarImpact result;
  result.static_deflection = at_rest;
  result.static_stress = std::abs(blow.force) * bar.stress_per_force;
  result.deflection =
      at_rest + std::sqrt(at_rest * at_rest + energy / bar.stiffness);
  result.stress = result.deflection * bar.stiffness * bar.stress_per_force;
  if (blow.force > 0.0) result.factor = result.deflection / at_rest;
  return result;
}

double deflection_at(const StruckBar& bar, const Blow& blow, double time) {
  const double w = std::sqrt(bar.stiffness / blow.mass);
  return blow.force / bar.stiffness * (1.0 - std::cos(w * time)) +
         blow.speed / w * std::sin(w * time);
}

double largest_speed(const StruckBar& bar, const Blow& blow, double stress,
                     StruckMass struck_mass) {
  const double y = stress / (bar.stress_per_force * bar.stiffness);
  // y² − 2 y_st y = m V²/k
  const double energy = bar.stiffness * y * y - 2.0 * blow.force * y;
  return std::sqrt(std::max(0.0, energy) /
                   (kept_energy(bar, blow, struck_mass) * blow.mass));
}

double first_period(const StruckBar& bar) {
  return 2.0 * std::numbers::pi *
         std::sqrt(bar.mass_part * bar.mass / bar.stiffness);
}

}  // namespace clevis::beam
