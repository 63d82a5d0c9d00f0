#pragma once

#include <array>
#include <complex>

namespace clevis::numerics {

/// Radau IIA of 3, 5 or 7 stages, orders 5, 9 and 13: collocation at the
/// nodes c of Radau's quadrature with the end of the step
/// ([HairerWanner1996] IV.5). Unknowns are z_i = y(t + c_i h) − y(t), with A
/// the method's matrix z = h A f.
struct RadauMethod {
  static constexpr int kMostStages = 7;
  using Weights = std::array<double, kMostStages>;
  using Table = std::array<Weights, kMostStages>;

  int stages{};
  Weights c{};
  Table inverse{};  ///< A⁻¹ = T Λ T⁻¹
  Table T{}, T_inverse{};
  /// Λ: a real eigenvalue, then pairs α ± i β as [α −β; β α].
  double real{};
  std::array<std::complex<double>, kMostStages / 2> pairs{};
  /// Σ error_i z_i / h + f(t, y), filtered by (real/h − J)⁻¹, is what an
  /// embedded formula of order `stages` differs by (IV.8).
  Weights error{};

  std::size_t count() const { return static_cast<std::size_t>(stages); }
  int order_of_error() const { return stages + 1; }
  /// Of the z_i in their polynomial at s steps from the start, where it is 0.
  Weights at(double s) const;
  /// The same through values at the c_i alone.
  Weights through_stages(double s) const;
};

/// @param stages  3, 5 or 7.
const RadauMethod& radau_method(int stages);

}  // namespace clevis::numerics
