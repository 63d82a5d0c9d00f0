#pragma once

#include <algorithm>
#include <vector>

#include "assessment/impact/struck_run.h"

namespace clevis::assessment {

/// Between what the peaks of a blow lie where its course hangs on little
/// things; low above high: it does not.
struct CourseSpread {
  double stress_low = 1.0, stress_high = 0.0;          ///< [Pa]
  double root_low = 1.0, root_high = 0.0;              ///< [Pa]
  double deflection_low = 1.0, deflection_high = 0.0;  ///< [m]
  double largest{};  ///< of the three, highest over lowest less one [1]

  bool is_there() const { return stress_low <= stress_high; }
};

/// Widens a band to hold these, all in the units of the band.
inline void widen(double low, double high, double& band_low,
                  double& band_high) {
  band_low = std::min(band_low, low);
  band_high = std::max(band_high, high);
}

/// A striker that bounces meets the swinging part sooner or later, and what
/// comes of it grows with every touch. The blow once more with masses of up to
/// 2 % more and less, of the same energy: what that changes by more than 1 %,
/// but for an even rise, cannot be told better, and neither can what the two
/// degrees differ by.
/// @param coarse  by this degree. @param fine  by the next.
template <int dim>
CourseSpread course_spread(const PartJob& job, const ImpactJob& impact,
                           const std::vector<stress::SingularZone>& zones,
                           int degree, const StruckRun<dim>& coarse,
                           const StruckRun<dim>& fine, StruckFaces<dim>& faces);

}  // namespace clevis::assessment
