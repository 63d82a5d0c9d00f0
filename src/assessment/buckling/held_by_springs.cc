#include "assessment/buckling/held_by_springs.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "part/buckling_limit.h"

namespace clevis::assessment {
namespace {

/// In words, of a part that its loads push over.
std::string what_holds(
    const elasticity::BucklingOnSprings::Position& position) {
  const double factor = *position.topples;
  std::string words =
      position.yields_slowly
          ? "it stands by friction, which breaks away as it leans by 1/200, or "
            "by gas that flows or takes heat"
      : factor > 0.0 ? "springs and servo axes alone hold it where it stands, "
                       "and its loads push them over"
                     : "nothing holds it where it stands, and its loads push "
                       "it over";
  if (factor < 1.0) words += ": the position is not stable";
  return words;
}

}  // namespace

double enough_buckling(const part::Limits& limits) {
  return std::max(kFirstOrderIsEnough, part::wanted_buckling_factor(limits));
}

bool count_springs(const PartJob& job,
                   const elasticity::BucklingMode::OnSprings& on,
                   double of_lowest_degree, BucklingResult& result) {
  constexpr double kCounts = 0.02;
  if (!on.counts() || !result.factor) return false;
  const double enough = enough_buckling(job.part.limits);
  const auto remark = [&](const std::string& more) {
    result.remark += (result.remark.empty() ? "" : "; ") + more;
  };
  if (on.together.is_known && !result.is_lower_bound()) {
    // Cells of the lowest degree are as much too stiff on springs.
    const double finer =
        of_lowest_degree > 0.0 ? *result.factor / of_lowest_degree : 1.0;
    const double together = finer / on.together.yield;
    const double change = together / *result.factor;
    if (std::abs(change - 1.0) < kCounts ||
        std::min(together, *result.factor) >= enough) {
      return false;
    }
    if (change > 1.0 && on.may_be_larger) {
      remark(
          fmt::format("springs and servo axes hold it: {:.4g} on them at the "
                      "instants that were solved, others may have less",
                      together));
      result.band_high = std::max(result.band_high, together);
      return true;
    }
    std::string others =
        fmt::format("; {:.4g} if its seats were held instead", *result.factor);
    if (on.springs > 0.0) {
      others += fmt::format(", {:.4g} if it were rigid", 1.0 / on.springs);
    }
    remark("on the springs and servo axes that hold it" + others);
    result.factor = together;
    result.band_low *= change;
    result.band_high *= change;
    return true;
  }
  const double own = on.softer * std::max(on.own, 1.0 / result.band_low);
  const double together = 1.0 / (own + on.springs);
  if (together > (1.0 - kCounts) * result.band_low || together >= enough) {
    return false;
  }
  result.band_low = together;
  remark(
      fmt::format("springs and servo axes that hold it yield, too: together at "
                  "{:.4g} or later, at {:.4g} if it were rigid",
                  together, 1.0 / on.springs));
  return true;
}

void Standing::take(const Standing& other) {
  const auto& [topples, is_open, stands, yields_slowly] = other.position;
  position.is_open |= is_open;
  position.stands |= stands;
  if (!topples || (position.topples && *position.topples <= *topples)) return;
  position.topples = topples;
  position.yields_slowly = yields_slowly;
  label = other.label;
  instant = other.instant;
}

void count_standing(const Standing& standing, double own_low,
                    BucklingResult& result) {
  if (!standing.position.topples) return;
  const double factor = *standing.position.topples;
  if (standing.position.yields_slowly &&
      (!result.factor || factor >= *result.factor)) {
    return;
  }
  // Springs and the part itself yield in series (Southwell).
  result.band_low = factor > 0.0 && result.factor
                        ? 1.0 / (1.0 / factor + 1.0 / own_low)
                        : 0.0;
  result.factor = result.band_high = factor;
  result.label = standing.label;
  result.instant = standing.instant;
  result.remark = what_holds(standing.position);
}

}  // namespace clevis::assessment
