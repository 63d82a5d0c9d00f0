#include "dynamics/struck_body/contact_law.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace clevis::dynamics {

double ContactLaw::force(double approach) const {
  if (approach <= 0.0 && !spring_.bilateral) return 0.0;
  return std::copysign(
      spring_.stiffness * std::pow(std::abs(approach), spring_.exponent),
      approach);
}

double ContactLaw::potential(double approach) const {
  if (approach <= 0.0 && !spring_.bilateral) return 0.0;
  return spring_.stiffness *
         std::pow(std::abs(approach), spring_.exponent + 1.0) /
         (spring_.exponent + 1.0);
}

double ContactLaw::slope(double approach) const {
  if (approach <= 0.0 && !spring_.bilateral) return 0.0;
  return spring_.stiffness * spring_.exponent *
         std::pow(std::abs(approach), spring_.exponent - 1.0);
}

double ContactLaw::mean_force(double a, double b) const {
  const bool both = spring_.bilateral || (a > 0.0 && b > 0.0);
  if (spring_.exponent == 1.0 && both) {
    return 0.5 * spring_.stiffness * (a + b);
  }
  constexpr double kNear = 0.1;  // the difference would lose digits
  const double size = std::max(std::abs(a), std::abs(b));
  if (std::abs(b - a) > kNear * size) {
    return (potential(b) - potential(a)) / (b - a);
  }
  // Gauss, five points: exact to round-off over so short a way.
  constexpr std::array<double, 3> kPoint = {0.0, 0.538469310105683,
                                            0.906179845938664};
  constexpr std::array<double, 3> kWeight = {
      0.568888888888889 / 2, 0.478628670499366 / 2, 0.236926885056189 / 2};
  const double middle = 0.5 * (a + b), half = 0.5 * (b - a);
  double mean = kWeight[0] * force(middle);
  for (std::size_t k = 1; k < kPoint.size(); ++k) {
    mean += kWeight[k] * (force(middle + half * kPoint[k]) +
                          force(middle - half * kPoint[k]));
  }
  return mean;
}

double ContactLaw::solve_step(double a, double b_free,
                              double compliance) const {
  // b - b_free + compliance · mean(a, b) rises with b: one zero, between
  // b_free and what the force at b_free leads to.
  const double first = mean_force(a, b_free);
  if (first == 0.0) return 0.0;
  double low = std::min(b_free, b_free - compliance * first);
  double high = std::max(b_free, b_free - compliance * first);
  double b = b_free;
  double mean = first;
  constexpr int kMost = 200;
  for (int i = 0; i < kMost; ++i) {
    const double rest = b - b_free + compliance * mean;
    (rest > 0.0 ? high : low) = b;
    const double way = b - a;
    const double slope = std::abs(way) > 1e-6 * std::abs(b)
                             ? (force(b) - mean) / way
                             : 0.5 * ContactLaw::slope(b);
    double next = b - rest / (1.0 + compliance * slope);
    if (!(next >= low && next <= high)) next = 0.5 * (low + high);
    const double change = std::abs(next - b);
    b = next;
    mean = mean_force(a, b);
    if (change <= 1e-15 * std::max(std::abs(a), std::abs(b))) break;
  }
  return mean;
}

HeadOn head_on(const loads::ContactSpring& spring, double energy) {
  HeadOn result;
  const double n = spring.exponent;
  result.approach =
      std::pow((n + 1.0) * energy / spring.stiffness, 1.0 / (n + 1.0));
  result.force = spring.stiffness * std::pow(result.approach, n);
  result.stiffness =
      result.approach > 0.0 ? result.force / result.approach : spring.stiffness;
  return result;
}

}  // namespace clevis::dynamics
