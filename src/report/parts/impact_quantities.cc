#include "report/parts/impact_quantities.h"

#include <algorithm>

#include "report/parts/peak_quantities.h"

namespace clevis::report {
namespace {

using assessment::DurationRatio;
using assessment::ImpactResult;
using assessment::ImpactRow;
using assessment::VibrationResult;
using assessment::WaveFrontRefinement;

constexpr Rule kRiseRule = {compare_within(1e-2, 0.0), "a time of a flat top"};
constexpr Rule kLaterRule = {
    compare_within(1e-2, 0.0),
    "of few shapes, and of a bouncing striker sensitive to all"};
constexpr Rule kLikeLaterRule = {compare_within(1e-2, 0.0), "as later_stress"};

Quantities<ImpactResult> striker_rows() {
  using S = ImpactResult;
  return {
      quantity<S>({"name", "/name", "", "impact"}, &S::name),
      quantity<S>({"source", "/source"}, &S::source),
      quantity<S>({"striker_mass", "/mass_kg", "kg", "", like_reactions(0.0)},
                  &S::mass),
      quantity<S>(
          {"striker_speed", "/speed_m_per_s", "m/s", "", like_reactions(1e-9)},
          &S::speed),
      quantity<S>(
          {"striker_force", "/pushing_N", "N", "", like_reactions(1e-6)},
          &S::force),
      quantity<S>({"contact_stiffness", "/contact_stiffness", "1"},
                  &S::stiffness),
      quantity<S>({"contact_exponent", "/contact_exponent", "1"}, &S::exponent),
      quantity<S>({"ideal_step", "/ideal_step"}, &S::is_ideal),
      quantity<S>({"mass_ratio", "/mass_ratio", "1"},
                  [](const S& blow) {
                    return blow.mass / blow.part_mass;
                  }),
  };
}

Quantities<ImpactResult> course_rows() {
  using S = ImpactResult;
  return {
      quantity<S>({"first_period", "/first_period_s", "s", "", kPureNumberRule},
                  &S::first_period),
      quantity<S>(
          {"contact_duration", "/load_duration_s", "s", "", kPureNumberRule},
          &S::load_duration),
      quantity<S>({"duration_ratio", "/duration_over_first_period", "1"},
                  [](const S& blow) {
                    return blow.load_duration / blow.first_period;
                  }),
      quantity<S>({"contact_rise", "/rise_time_s", "s", "", kRiseRule},
                  &S::rise_time),
      quantity<S>(
          {"contact_force", "/peak_force_N", "N", "", like_the_peak(1e-6)},
          &S::peak_force),
      quantity<S>(
          {"dynamic_factor", "/dynamic_factor", "1", "", kPureNumberRule},
          &S::dynamic_factor),
  };
}

Quantities<ImpactResult> judged_rows() {
  using S = ImpactResult;
  return {
      quantity<S>({"peak_von_mises", "/stress_MPa", "MPa", "impact_von_mises",
                   kPeakRule},
                  &S::stress),
      quantity<S>({"band_low", "/band_MPa/0", "MPa", "impact_low", kStressRule},
                  &S::band_low),
      quantity<S>(
          {"band_high", "/band_MPa/1", "MPa", "impact_high", kStressRule},
          &S::band_high),
      quantity<S>({"deflection", "/deflection_mm", "mm", "impact_deflection",
                   kLengthRule},
                  &S::deflection),
      quantity<S>({"deflection_low", "/deflection_band_mm/0", "mm", "",
                   kLengthRule, Since::kLater},
                  &S::deflection_low),
      quantity<S>({"deflection_high", "/deflection_band_mm/1", "mm", "",
                   kLengthRule, Since::kLater},
                  &S::deflection_high),
      quantity<S>({"safety_factor", "/safety_factor", "1",
                   "impact_safety_factor", kPureNumberRule},
                  &S::safety_factor),
  };
}

Quantities<ImpactResult> later_rows() {
  using S = ImpactResult;
  return {
      quantity<S>({"looked_for", "/searched_s", "s"}, &S::looked_for),
      quantity<S>({"later_stress", "/later_stress_ratio", "1", "", kLaterRule,
                   Since::kLater},
                  &S::later_stress),
      quantity<S>({"later_section", "/later_section_ratio", "1"},
                  &S::later_root),
      quantity<S>({"response_scatter", "/response_scatter_percent", "%"},
                  &S::spread),
      quantity<S>({"later_deflection", "/later_deflection_ratio", "1", "",
                   kLikeLaterRule, Since::kLater},
                  &S::later_deflection),
      quantity<S>({"free_vibration_stress", "/free_vibration_stress_ratio", "1",
                   "", kLikeLaterRule},
                  &S::free_vibration_stress),
      quantity<S>({"free_vibration_deflection",
                   "/free_vibration_deflection_ratio", "1", "", kLikeLaterRule},
                  &S::free_vibration_deflection),
      quantity<S>({"reason", "/reason"}, &S::reason),
  };
}

Quantities<WaveFrontRefinement> refinement_rows() {
  using S = WaveFrontRefinement;
  return {
      quantity<S>({"refinement_degree", "/degree"}, &S::degree),
      quantity<S>({"settles", "/stress_converges", "", "", kVerdictRule},
                  &S::settles),
      quantity<S>({"left_above", "/left_above_percent", "%"}, &S::above),
      quantity<S>({"left_below", "/left_below_percent", "%"}, &S::below),
  };
}

Quantities<ImpactResult> blow_rows() {
  using S = ImpactResult;
  Quantities<S> rows = striker_rows();
  append(course_rows(), rows);
  append(judged_rows(), rows);
  const auto first_of_section = rows.size();
  add_rows_of(
      section_quantities(), "/support_section", true,
      [](const S& blow) {
        return blow.root ? &*blow.root : nullptr;
      },
      rows);
  // parts.csv has the part's, which is the largest
  for (std::size_t i = first_of_section; i < rows.size(); ++i) {
    rows[i].column.clear();
  }
  append(later_rows(), rows);
  add_rows_of(
      refinement_rows(), "/refinement", true,
      [](const S& blow) {
        return blow.refinement.stress.empty() ? nullptr : &blow.refinement;
      },
      rows);
  return rows;
}

Quantities<ImpactRow> blow_model_rows() {
  using S = ImpactRow;
  return {
      quantity<S>({"model", "/model", "", "", kModelRule},
                  [](const S& row) {
                    return assessment::model_name(row);
                  }),
      quantity<S>({"peak_von_mises", "/stress_MPa", "MPa", "", kPeakRule},
                  &S::stress),
      quantity<S>(
          {"section_stress", "/root_stress_MPa", "MPa", "", kStressRule},
          &S::nominal),
      quantity<S>({"ratio_to_judged", "/ratio", "1"}, &S::ratio),
      quantity<S>(
          {"face_deflection", "/face_deflection_mm", "mm", "", kLengthRule},
          &S::face),
      quantity<S>({"deflection", "/deflection_mm", "mm", "", kLengthRule},
                  &S::deflection),
      quantity<S>({"error", "/error_percent", "%"}, &S::error),
      quantity<S>({"seconds", "/seconds", "s"}, &S::seconds),
      quantity<S>({"remark", "/remark"}, &S::remark),
  };
}

Quantities<DurationRatio> load_pace_rows() {
  using S = DurationRatio;
  return {
      quantity<S>({"impact", "/impact"}, &S::impact),
      quantity<S>({"duration", "/duration_s", "s"}, &S::duration),
      quantity<S>({"rise_time", "/rise_time_s", "s"}, &S::rise_time),
      quantity<S>({"first_period", "/first_period_s", "s"}, &S::first_period),
      quantity<S>({"duration_ratio", "/duration_over_first_period", "1"},
                  &S::ratio),
      quantity<S>({"amplification", "/amplification", "1"}, &S::amplification),
      quantity<S>({"treatment", "/treatment"}, &S::treatment),
  };
}

Quantities<VibrationResult> vibration_answer_rows() {
  using S = VibrationResult;
  return {
      quantity<S>({"vibration_ratio", "/ratio", "1", "vibration_ratio",
                   kPureNumberRule},
                  &S::ratio),
      quantity<S>({"governs", "/governs", "", "vibration_governs"},
                  &S::governs),
      quantity<S>({"peak_von_mises", "/peak_MPa", "MPa", "vibration_von_mises",
                   kPeakRule},
                  &S::peak),
      quantity<S>(
          {"band_low", "/band_MPa/0", "MPa", "vibration_low", kStressRule},
          &S::band_low),
      quantity<S>(
          {"band_high", "/band_MPa/1", "MPa", "vibration_high", kStressRule},
          &S::band_high),
      quantity<S>({"position", "/at_mm", "mm"}, &S::at),
      quantity<S>({"group", "/group"}, &S::group),
      quantity<S>({"peak_instant", "/instant_s", "s", "", kInstantRule},
                  &S::time),
  };
}

Quantities<VibrationResult> vibration_method_rows() {
  using S = VibrationResult;
  return {
      quantity<S>({"from", "/from_s", "s"}, &S::from),
      quantity<S>({"to", "/to_s", "s"}, &S::to),
      quantity<S>({"model", "/model", "", "", kModelRule}, &S::model),
      quantity<S>({"shapes", "/shapes"}, &S::shapes),
      quantity<S>({"lowest_frequency", "/lowest_frequency_hz", "Hz"},
                  &S::lowest_frequency),
      quantity<S>({"highest_frequency", "/highest_frequency_hz", "Hz"},
                  &S::highest_frequency),
      quantity<S>({"degree_error", "/degree_error_percent", "%"},
                  &S::degree_error),
      quantity<S>({"shape_error", "/shape_error_percent", "%"},
                  &S::shape_error),
      quantity<S>({"sampling_error", "/sampling_error_percent", "%"},
                  &S::sampling_error),
      quantity<S>({"instants_error", "/instants_error_percent", "%"},
                  &S::path_error),
      quantity<S>({"seconds", "/seconds", "s"}, &S::seconds),
  };
}

}  // namespace

const Quantities<ImpactResult>& blow_quantities() {
  static const Quantities<ImpactResult> rows = blow_rows();
  return rows;
}

const Quantities<ImpactRow>& blow_model_quantities() {
  static const Quantities<ImpactRow> rows = blow_model_rows();
  return rows;
}

const Quantities<DurationRatio>& duration_ratio_quantities() {
  static const Quantities<DurationRatio> rows = load_pace_rows();
  return rows;
}

const Quantities<VibrationResult>& vibration_quantities() {
  static const Quantities<VibrationResult> rows = [] {
    Quantities<VibrationResult> all = vibration_answer_rows();
    append(vibration_method_rows(), all);
    return all;
  }();
  return rows;
}

const ImpactResult* governing_blow(const assessment::PartResult& part) {
  const auto least =
      std::ranges::min_element(part.impacts, {}, &ImpactResult::safety_factor);
  return least != part.impacts.end() ? &*least : nullptr;
}

const VibrationResult* computed_vibration(const assessment::PartResult& part) {
  return part.vibration.ratio ? &part.vibration : nullptr;
}

}  // namespace clevis::report
