#pragma once

#include <span>

namespace clevis::stress {

/// A quantity computed with displacements of rising degree on one mesh.
struct SequenceValue {
  int degree{};
  double value{};
};

enum class Convergence { kConverged, kSingular, kNotConverged };

/// Estimate of the exact value by the sequence.
struct Band {
  double value{};  ///< of the highest degree
  double low{}, high{};
  Convergence verdict{};
};

/// A small last step after a large one may be one by chance: half of a band is
/// this share of the change before at least [1].
constexpr double kShareOfChangeBefore = 0.1;

/// Band of a quantity from its p-sequence.
///
/// With the last two changes d₁, d₂ and q = |d₂/d₁| bounded to [0.35, 0.8],
/// what is still to come is estimated by the geometric series
/// |d₂| q/(1 − q), never less than |d₂|/2 or a share of |d₁|. Verdict:
/// converged if the half-width is within the tolerance; singular if it is not
/// and the value grows by the last two changes, which hardly shrink (at a
/// re-entrant corner the peak grows like p^(2−2λ): q = 0.98 for a 270° notch,
/// 0.87 for a clamped edge with degrees 2, 3, 4); not converged otherwise, as
/// where it sinks.
/// @param tolerance  half-width over value [1].
/// @param share_of_change_before  of |d₁| [1].
Band peak_band(std::span<const SequenceValue> sequence, double tolerance,
               double share_of_change_before = kShareOfChangeBefore);

/// A quantity that was also computed with higher degrees nearby alone
/// (elasticity::enrich).
struct LocalValues {
  double before{};  ///< of the degree before
  double value{};   ///< of the degree that was solved for
  double finer{};   ///< nearby two degrees higher
  double finest{};  ///< nearby three degrees higher
  /// Error of other places, e.g. the peak of which this is not one.
  double elsewhere = 0.0;
};

/// Band of such a quantity: about the finest value, to either side 0.65 of its
/// difference to the solved one; at least what the last
/// degree nearby has changed, and for what comes from far away a hundredth of
/// what the last degree everywhere has and of what other places are off; never
/// less than a hundredth of the tolerance. It holds the solved value.
/// @param tolerance  of the distance from the value to the far end, over the
///   value [1].
Band local_band(const LocalValues& values, double tolerance);

}  // namespace clevis::stress
