#pragma once

#include <array>
#include <complex>

namespace clevis::dynamics {

/// One step of the damping scheme: z -> R(h A) z with
///
///     R(x) = Σ a_j (1 − γ x)^-j, j = 1…4,
///
/// R(x) = e^x + O(x⁵), |R(i y)| ≤ 1, R(∞) = 0: the only real γ for which four
/// stages with one pole are of fourth order and L-stable. It leaves waves of
/// y = ω h < 0.5 alone (5e-4 of the amplitude a step at 0.5, 1.6 % at 1, 16 %
/// at 2, all in the end) and delays none of those that it leaves.
///
/// Source: [Norsett1974]; [HairerWanner1996] table IV.6.4.
struct DampedScheme {
  static constexpr double kPole = 0.57281606248213;  ///< γ
  static constexpr int kStages = 4;

  /// Weights a_1 … a_4 [1].
  static const std::array<double, kStages>& weights();

  /// R(i y) for the phase y = ω h >= 0 of a step [rad].
  static std::complex<double> amplification(double phase);

  /// The same over a part of the step [1]: R(i y)^part on the branch that is
  /// next to e^(i y part).
  static std::complex<double> amplification(double phase, double part);
};

}  // namespace clevis::dynamics
