#include "assessment/job/part_result.h"

#include <fmt/format.h>

namespace clevis::assessment {
namespace {

std::string_view words_of(ImpactModel model) {
  switch (model) {
    case ImpactModel::kBeamPublished:
      return "beam, published";
    case ImpactModel::kBeamCorrected:
      return "beam, corrected";
    case ImpactModel::kBeamMovingAlong:
      return "beam, corrected, its mass moving along";
    case ImpactModel::kStaticTimesFactor:
      return "static elements x factor";
    case ImpactModel::kElementsInTime:
      return "dynamic elements";
  }
  return "";
}

}  // namespace

const PeakStress& judged_peak(const PartResult& result) {
  return result.peak_outside ? *result.peak_outside : result.peak;
}

std::string model_name(const ImpactRow& row) {
  std::string name(words_of(row.model));
  if (!row.scheme.empty()) name += ", " + row.scheme;
  if (row.degree) name += fmt::format(", p = {}", *row.degree);
  return name;
}

}  // namespace clevis::assessment
