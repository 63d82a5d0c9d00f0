#include "assessment/second_order/checked_linear.h"

#include <algorithm>

namespace clevis::assessment {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kOfDegree = 1.05;  // where only a low one is known

/// The check's value over this degree's, of the points that it refers to.
struct Scale {
  double value = kOfDegree;
  bool is_known = false;
};
Scale scale_to(double checked, double here) {
  if (!(here > 0.0)) return {};
  return {std::max(1.0, checked / here), true};
}

double over(double checked, double here) {
  return here > 0.0 ? checked / here : 1.0;
}

}  // namespace

LinearPoint LinearPoint::between(const LinearPoint& other, double stress,
                                 double displacement) const {
  const double of_stress =
      std::max(over(peak, here), over(other.peak, other.here));
  const double of_displacement =
      std::max(over(deflects, moved), over(other.deflects, other.moved));
  return {stress,
          of_stress * stress,
          displacement,
          of_displacement * displacement,
          is_peak_known && other.is_peak_known,
          is_deflection_known && other.is_deflection_known};
}

CheckedLinear::CheckedLinear(const PartResult& result,
                             const std::vector<InstantRow>& rows,
                             std::size_t set, const Swing& swing)
    : result_(result), set_(set), swing_(swing) {
  if (&judged_peak(result) != &result.peak)
    return;  // rows have the zones', too
  for (const InstantRow& row : rows) {
    if (row.load_set == set) peaks_[{row.label, row.time}] = row.peak;
  }
}

bool CheckedLinear::is_judged(const std::string& label, double time) const {
  const PeakStress& judged = judged_peak(result_);
  return label == judged.label && time == judged.instant;
}

bool CheckedLinear::deflects_most(const std::string& label, double time) const {
  return result_.deflection_set == set_ && label == result_.deflection_label &&
         time == result_.deflection_instant;
}

bool CheckedLinear::refers_to(const std::string& label, double time) const {
  return is_judged(label, time) || deflects_most(label, time);
}

std::vector<LinearPoint> CheckedLinear::of(const std::vector<LoadPoint>& points,
                                           const VectorXd& stress,
                                           const VectorXd& displacement) const {
  double judged = 0.0, deflected = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto at = static_cast<Index>(i);
    const LoadPoint& point = points[i];
    if (is_judged(point.label, point.time)) {
      judged = std::max(judged, stress[at]);
    }
    if (deflects_most(point.label, point.time)) {
      const double swung = point.is_motion ? swing_.deflection : 1.0;
      deflected = std::max(deflected, swung * displacement[at]);
    }
  }
  const Scale of_peak = scale_to(judged_peak(result_).value, judged);
  const Scale of_deflection = scale_to(result_.deflection, deflected);
  std::vector<LinearPoint> all;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto at = static_cast<Index>(i);
    all.push_back({stress[at], of_peak.value * stress[at], displacement[at],
                   of_deflection.value * displacement[at], of_peak.is_known,
                   of_deflection.is_known});
    const auto row = peaks_.find({points[i].label, points[i].time});
    if (row == peaks_.end()) continue;
    all.back().peak = row->second;
    all.back().is_peak_known = true;
  }
  return all;
}

}  // namespace clevis::assessment
