#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "assessment/impact/struck_run.h"

namespace clevis::assessment {

/// Range of the peaks of a blow under a small variation of the striker's mass.
struct ResponseScatter {
  double stress_low{}, stress_high{};          ///< [Pa]
  double root_low{}, root_high{};              ///< [Pa]
  double deflection_low{}, deflection_high{};  ///< [m]
  double largest{};  ///< of the three, highest over lowest less one [1]
};

/// Widens a band to hold these, all in the units of the band.
inline void widen(double low, double high, double& band_low,
                  double& band_high) {
  band_low = std::min(band_low, low);
  band_high = std::max(band_high, high);
}

/// Scatter of the peaks of a striker that bounces: repeated contact makes the
/// response chaotic. Repeats the blow with the striker's mass varied by up to
/// 2 % at equal energy. A scatter of more than 1 % beyond a linear trend is the
/// result, widened by the difference of the two degrees; an insensitive
/// response has none.
/// @param coarse  by this degree. @param fine  by the next.
template <int dim>
std::optional<ResponseScatter> response_scatter(
    const PartJob& job, const ImpactJob& impact,
    const std::vector<stress::SingularZone>& zones, int degree,
    const StruckRun<dim>& coarse, const StruckRun<dim>& fine,
    StruckFaces<dim>& faces);

}  // namespace clevis::assessment
