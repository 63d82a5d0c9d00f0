#include "assessment/judge/time_sampling_error.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "loads/history/motion_instants.h"
#include "stress/field/stress_history.h"

namespace clevis::assessment {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr Index kFew = 12;

/// Of a piece between two events. A short one has instants as close as its
/// loads change: a third of the fall beside its highest, as if halved.
double doubt_of_piece(const VectorXd& peak) {
  if (peak.size() >= kFew) return stress::time_sampling_error(peak);
  Index top = 0;
  const double highest = peak.maxCoeff(&top);
  double lowest = highest;
  if (top > 0) lowest = std::min(lowest, peak[top - 1]);
  if (top + 1 < peak.size()) lowest = std::min(lowest, peak[top + 1]);
  return (highest - lowest) / 3.0;
}

/// Of the pieces of a motion that events separate.
/// @param apart  two sides of an event are no farther [s].
double doubt_of_pieces(const std::vector<double>& time, const VectorXd& peak,
                       double apart) {
  const Index n = peak.size();
  std::vector<Index> starts{0};
  for (Index i = 1; i < n; ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (time[at] - time[at - 1] <= apart) starts.push_back(i);
  }
  if (starts.size() == 1) return stress::time_sampling_error(peak);
  starts.push_back(n);
  double bound = 0.0;
  for (std::size_t k = 0; k + 1 < starts.size(); ++k) {
    const VectorXd piece = peak.segment(starts[k], starts[k + 1] - starts[k]);
    bound = std::max(bound, piece.maxCoeff() + doubt_of_piece(piece));
  }
  return bound - peak.maxCoeff();
}

/// Of the way between rows on which instants lie.
/// @param rows  their indices. @param peak  of all instants.
double doubt_between(const std::vector<Index>& rows, const VectorXd& peak) {
  const double largest = peak.maxCoeff();
  double bound = largest;
  for (std::size_t r = 1; r < rows.size(); ++r) {
    const Index steps = rows[r] - rows[r - 1];
    if (steps == 1) continue;
    const VectorXd piece = peak.segment(rows[r - 1], steps + 1);
    bound =
        std::max(bound, piece.maxCoeff() + stress::time_sampling_error(piece));
  }
  return bound - largest;
}

/// Of the loads, at the seats where they act.
double doubt_of_loads(const loads::LoadHistory& history, const VectorXd& peak) {
  const auto n = static_cast<Index>(loads::motion_length(history));
  if (history.unseen > 0.0) return history.unseen * peak.head(n).maxCoeff();
  if (n < 2) return 0.0;
  std::vector<Index> rows;
  std::vector<double> times;
  for (Index i = 0; i < n; ++i) {
    const auto& instant = history.instants[static_cast<std::size_t>(i)];
    if (instant.is_between_rows) continue;
    rows.push_back(i);
    times.push_back(instant.time);
  }
  const double between = doubt_between(rows, peak.head(n));
  if (history.rows == part::BetweenRows::kLinear) return between;
  const double apart = loads::kEventSides * loads::motion_duration(history);
  return between + doubt_of_pieces(times, peak(rows), apart);
}

}  // namespace

double time_sampling_error(const loads::LoadHistory& history,
                           const VectorXd& peak) {
  const auto n = static_cast<Index>(loads::motion_length(history));
  return doubt_of_loads(history, peak) +
         history.slide_excess * peak.head(n).maxCoeff();
}

}  // namespace clevis::assessment
