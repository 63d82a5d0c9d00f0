#include "machine/transmissions/compliance.h"

#include <cmath>
#include <numbers>

namespace clevis::machine {
namespace {

constexpr double kPi = std::numbers::pi;

double law_compliance(const Bar& bar, BallScrewUnit) {
  return bar.length / (bar.youngs_modulus * bar.area);
}

double law_compliance(const Shaft& shaft, BallScrewUnit) {
  const double polar_moment =
      kPi / 32.0 * (std::pow(shaft.diameter, 4) - std::pow(shaft.bore, 4));
  return shaft.length / (shaft.shear_modulus * polar_moment);
}

double law_compliance(const Key& key, BallScrewUnit) {
  return key.constant /
         (key.diameter * key.diameter * key.length * key.height * key.count);
}

double law_compliance(const GearTeeth& gear, BallScrewUnit) {
  return 1.0 / (gear.modulus * gear.radius * gear.radius * gear.width);
}

double law_compliance(const Thread& thread, BallScrewUnit) {
  const double area = kPi / 4.0 *
                      (thread.diameter * thread.diameter -
                       thread.root_diameter * thread.root_diameter);
  return thread.constant / area;
}

/// The formula takes millimetres and newtons.
double law_compliance(const BallScrew& screw, BallScrewUnit unit) {
  constexpr double kMillimetre = 1e-3, kMicrometre = 1e-6;
  const double stiffness = 2.6 *
                           std::pow(screw.circle_diameter / kMillimetre, 0.89) *
                           std::pow(screw.ball_diameter / kMillimetre, -0.56) *
                           std::pow(screw.turns, 0.67) *
                           std::pow(screw.preload, 0.33) * screw.class_factor;
  return (unit == BallScrewUnit::kCorrected ? kMicrometre : kMillimetre) /
         stiffness;
}

double law_compliance(const GivenCompliance& given, BallScrewUnit) {
  return given.value;
}

double law_compliance(const ElementGroup& group, BallScrewUnit unit) {
  double sum = 0.0;
  for (const CompliantElement& element : group.elements) {
    const double e = compliance(element, unit);
    sum += group.parallel ? 1.0 / e : e;
  }
  return group.parallel ? 1.0 / sum : sum;
}

/// Table values of the elements, in the order of the variant.
struct Naming {
  const char *type, *formula;
};
constexpr Naming kNames[] = {
    {"bar", "l/(E A)"},
    {"shaft", "32 l/(pi G (d^4 - d_i^4))"},
    {"key", "K/(d^2 l h z)"},
    {"gear_teeth", "1/(K_M r^2 b)"},
    {"thread", "K_p/(pi/4 (d^2 - d_3^2))"},
    {"ball_screw", "1/(2.6 d_o^0.89 d_b^-0.56 K_B^0.67 F^0.33 K_R)"},
    {"given", "given"}};

}  // namespace

double compliance(const CompliantElement& element, BallScrewUnit unit) {
  return std::visit(
      [unit](const auto& law) {
        return law_compliance(law, unit);
      },
      element.law);
}

bool is_angular(const CompliantElement& element) {
  if (const auto* given = std::get_if<GivenCompliance>(&element.law)) {
    return given->angular;
  }
  if (const auto* group = std::get_if<ElementGroup>(&element.law)) {
    return is_angular(group->elements.front());
  }
  return std::holds_alternative<Shaft>(element.law) ||
         std::holds_alternative<Key>(element.law) ||
         std::holds_alternative<GearTeeth>(element.law);
}

const char* type_name(const CompliantElement& element) {
  if (const auto* group = std::get_if<ElementGroup>(&element.law)) {
    return group->parallel ? "parallel" : "series";
  }
  const auto* key = std::get_if<Key>(&element.law);
  if (key != nullptr && key->spline) return "spline";
  return kNames[element.law.index()].type;
}

const char* formula(const CompliantElement& element) {
  if (const auto* group = std::get_if<ElementGroup>(&element.law)) {
    return group->parallel ? "1/sum(1/e_i)" : "sum(e_i)";
  }
  return kNames[element.law.index()].formula;
}

}  // namespace clevis::machine
