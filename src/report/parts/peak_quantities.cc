#include "report/parts/peak_quantities.h"

namespace clevis::report {
namespace {

using assessment::ErrorShares;
using assessment::PeakStress;
using assessment::SupportStress;

Quantities<ErrorShares> share_rows() {
  using S = ErrorShares;
  return {
      quantity<S>({"mesh_error", "/mesh", "MPa", "mesh_error"}, &S::mesh),
      quantity<S>({"model_share", "/model", "MPa"}, &S::model),
      quantity<S>({"time_error", "/time", "MPa", "time_error"}, &S::time),
      quantity<S>({"sharing_error", "/sharing", "MPa", "sharing_error"},
                  &S::sharing),
      quantity<S>({"change_point_error", "/change_points", "MPa"},
                  &S::change_points),
  };
}

Quantities<PeakStress> peak_rows() {
  using S = PeakStress;
  const auto verdict = [](const S& peak) {
    return text(peak.verdict);
  };
  Quantities<S> rows{
      quantity<S>(
          {"peak_von_mises", "/value_MPa", "MPa", "peak_von_mises", kPeakRule},
          &S::value),
      quantity<S>({"band_low", "/band_MPa/0", "MPa", "band_low", kStressRule},
                  &S::band_low),
      quantity<S>({"band_high", "/band_MPa/1", "MPa", "band_high", kStressRule},
                  &S::band_high),
      quantity<S>({"discretization_error", "/discretization_error_MPa", "MPa",
                   "discretization_error"},
                  &S::discretization_error),
      quantity<S>({"model_error", "/model_error_MPa", "MPa", "model_error"},
                  &S::model_error),
  };
  add_member_rows(share_rows(), "/errors_MPa", &S::shares, rows);
  append(
      Quantities<S>{
          quantity<S>(
              {"peak_verdict", "/verdict", "", "peak_verdict", kVerdictRule},
              verdict),
          quantity<S>({"peak_position", "/at_mm", "mm", "peak", kPlaceRule},
                      &S::at),
          quantity<S>({"peak_group", "/group", "", "peak_group"}, &S::group),
          quantity<S>(
              {"peak_instant", "/instant_s", "s", "peak_instant", kInstantRule},
              &S::instant),
          quantity<S>({"peak_case", "/case", "", "peak_case"}, &S::label),
          quantity<S>({"degree_nearby", "/degree_nearby"}, &S::degree_nearby),
          quantity<S>({"field_maximum", "/field_maximum_MPa", "MPa"},
                      &S::field_maximum),
          quantity<S>({"jump", "/jump_MPa", "MPa"}, &S::jump)},
      rows);
  return rows;
}

Quantities<SupportStress> section_rows() {
  using S = SupportStress;
  return {
      quantity<S>({"section", "/section", "", "section"}, &S::section),
      quantity<S>({"section_stress", "/nominal_stress_MPa", "MPa",
                   "section_stress", kStressRule},
                  &S::value),
      quantity<S>(
          {"section_low", "/band_MPa/0", "MPa", "section_low", kStressRule},
          &S::band_low),
      quantity<S>(
          {"section_high", "/band_MPa/1", "MPa", "section_high", kStressRule},
          &S::band_high),
      quantity<S>({"section_instant", "/instant_s", "s"}, &S::instant),
      quantity<S>({"section_case", "/instant", "", "section_case"}, &S::label),
  };
}

}  // namespace

const Quantities<PeakStress>& peak_quantities() {
  static const Quantities<PeakStress> rows = peak_rows();
  return rows;
}

const Quantities<SupportStress>& section_quantities() {
  static const Quantities<SupportStress> rows = section_rows();
  return rows;
}

std::string_view text(assessment::PeakVerdict verdict) {
  switch (verdict) {
    case assessment::PeakVerdict::kConverged:
      return "converged";
    case assessment::PeakVerdict::kSingular:
      return "singular";
    case assessment::PeakVerdict::kNotConverged:
      break;
  }
  return "not converged";
}

}  // namespace clevis::report
