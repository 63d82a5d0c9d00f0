#include "dynamics/struck_body/damped_scheme.h"

#include <cmath>
#include <numbers>

namespace clevis::dynamics {
namespace {

constexpr int kStages = DampedScheme::kStages;

double binomial(int n, int k) {
  return k == 0 ? 1.0 : binomial(n, k - 1) * (n - k + 1) / k;
}

/// Of the numerator of R: what agrees with e^x up to x³ (and, by the choice of
/// the pole, up to x⁴).
std::array<double, kStages> numerator() {
  std::array<double, kStages> result{};
  for (int j = 0; j < kStages; ++j) {
    for (int k = 0; k <= j; ++k) {
      result[static_cast<std::size_t>(j)] += std::pow(-DampedScheme::kPole, k) *
                                             binomial(kStages, k) /
                                             std::tgamma(j - k + 1.0);
    }
  }
  return result;
}

/// With t = 1/(1 − γ x): x^j t⁴ = γ^-j (t − 1)^j t^(4 − j).
std::array<double, kStages> partial_fractions() {
  std::array<double, kStages> result{};
  const auto terms = numerator();
  for (int j = 0; j < kStages; ++j) {
    const double scale =
        terms[static_cast<std::size_t>(j)] / std::pow(DampedScheme::kPole, j);
    for (int k = 0; k <= j; ++k) {  // (t − 1)^j
      const double sign = (j - k) % 2 == 0 ? 1.0 : -1.0;
      const int power = k + kStages - j;
      result[static_cast<std::size_t>(power - 1)] +=
          scale * sign * binomial(j, k);
    }
  }
  return result;
}

}  // namespace

const std::array<double, kStages>& DampedScheme::weights() {
  static const auto values = partial_fractions();
  return values;
}

std::complex<double> DampedScheme::amplification(double phase) {
  const std::complex<double> t = 1.0 / std::complex<double>(1, -kPole * phase);
  std::complex<double> sum = 0.0;
  for (int j = kStages - 1; j >= 0; --j) {
    sum = t * (weights()[static_cast<std::size_t>(j)] + sum);
  }
  return sum;
}

std::complex<double> DampedScheme::amplification(double phase, double part) {
  const std::complex<double> whole = amplification(phase);
  double angle = std::arg(whole);
  constexpr double kTurned = 2.0;  // the angle grows with the phase
  if (phase > kTurned && angle < 0.0) angle += 2.0 * std::numbers::pi;
  return std::polar(std::pow(std::abs(whole), part), angle * part);
}

}  // namespace clevis::dynamics
