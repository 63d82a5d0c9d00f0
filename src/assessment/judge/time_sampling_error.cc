#include "assessment/judge/time_sampling_error.h"

#include <algorithm>
#include <cmath>

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

/// Of the loads, at the seats where they act.
double doubt_of_loads(const loads::LoadHistory& history, const VectorXd& peak) {
  const std::vector<loads::InstantLoad>& instants = history.instants;
  const auto n = static_cast<Index>(loads::motion_length(history));
  if (history.rows == part::BetweenRows::kLinear) return 0.0;
  if (history.unseen > 0.0) return history.unseen * peak.head(n).maxCoeff();
  const auto time = [&](Index i) {
    return instants[static_cast<std::size_t>(i)].time;
  };
  const double apart = loads::kEventSides * loads::motion_duration(history);
  std::vector<Index> starts{0};
  for (Index i = 1; i < n; ++i) {
    if (time(i) - time(i - 1) <= apart) starts.push_back(i);
  }
  if (starts.size() == 1) return stress::time_sampling_error(peak.head(n));
  starts.push_back(n);
  double bound = 0.0;
  for (std::size_t k = 0; k + 1 < starts.size(); ++k) {
    const VectorXd piece = peak.segment(starts[k], starts[k + 1] - starts[k]);
    bound = std::max(bound, piece.maxCoeff() + doubt_of_piece(piece));
  }
  return bound - peak.head(n).maxCoeff();
}

}  // namespace

double time_sampling_error(const loads::LoadHistory& history,
                           const VectorXd& peak) {
  const auto n = static_cast<Index>(loads::motion_length(history));
  return doubt_of_loads(history, peak) +
         history.slide_excess * peak.head(n).maxCoeff();
}

}  // namespace clevis::assessment
