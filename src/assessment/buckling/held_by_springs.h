#pragma once

#include <string>

#include "assessment/job/part_job.h"
#include "elasticity/buckling/buckling.h"

namespace clevis::assessment {

/// Of a factor from which on first order theory is enough: EN 1993-1-1, 5.2.1.
constexpr double kFirstOrderIsEnough = 10.0;

/// A part's factor beyond which nothing more is asked of it [1].
double enough_buckling(const part::Limits& limits);

/// How loads leave a part that stands while its motion lasts.
struct Standing {
  elasticity::BucklingOnSprings::Position position;
  std::string label;  ///< of the motion's last instant
  double instant{};   ///< [s]

  /// Of several load sets: that with the least factor, open if one is.
  void take(const Standing& other);
};

/// Of a part on springs of its mechanism: where they and its joints hold it as
/// often as balance needs the factor is that on springs; else the band reaches
/// down to where both buckle together at the latest.
/// @return whether the band has changed.
/// @param of_lowest_degree  factor by which `on` is measured [1]; 0: not known.
/// @param result  as its seats hold the part.
bool count_springs(const PartJob& job,
                   const elasticity::BucklingMode::OnSprings& on,
                   double of_lowest_degree, BucklingResult& result);

/// The part has no more than the factor [1] of its position, however stiff it
/// is; nothing changes where its loads do not push it over.
/// @param own_low  lower end of its band as its seats hold it [1].
void count_standing(const Standing& standing, double own_low,
                    BucklingResult& result);

}  // namespace clevis::assessment
