#include "report/parts/part_quantities.h"

#include "part/verdict.h"
#include "report/parts/part_impact_output.h"
#include "report/parts/peak_quantities.h"

namespace clevis::report {
namespace {

using assessment::BeamComparison;
using assessment::BucklingResult;
using assessment::FiniteMotion;
using assessment::PartResult;
using assessment::PartSeconds;
using assessment::PeakStress;
using assessment::SecondOrderResult;
using assessment::SelfChecks;

constexpr Rule kMassRule = {
    compare_within(1e-6, 0.0),
    "an integral over the mesh: 0.1 mm of geometry moves it by 1e-5 or more"};
constexpr Rule kBeamRule = {
    compare_within(5e-4, 1e-6),
    "closed forms: only the section cuts through the mesh may move them"};

constexpr Rule like_beam_stress(double absolute) {
  return {compare_within(5e-4, absolute), "as beam_stress"};
}

/// Deciding measure where a singular zone governs.
void add_outside_peak(Quantities<PartResult>& rows) {
  const std::string key = "/peak_outside_singular_zones";
  const auto of = [](double PeakStress::*member) {
    return [member](const PartResult& part) {
      return part.peak_outside ? std::optional((*part.peak_outside).*member)
                               : std::nullopt;
    };
  };
  using S = PartResult;
  rows.push_back(quantity<S>({"outside_von_mises", key + "/value_MPa", "MPa",
                              "outside_von_mises", kStressRule},
                             of(&PeakStress::value)));
  rows.push_back(quantity<S>(
      {"outside_low", key + "/band_MPa/0", "MPa", "outside_low", kStressRule},
      of(&PeakStress::band_low)));
  rows.push_back(quantity<S>(
      {"outside_high", key + "/band_MPa/1", "MPa", "outside_high", kStressRule},
      of(&PeakStress::band_high)));
}

/// An end of the band, where there is one.
auto buckling_band(double BucklingResult::*end) {
  return [end](const BucklingResult& buckling) {
    return buckling.factor ? std::optional(buckling.*end) : std::nullopt;
  };
}

Quantities<BucklingResult> buckling_rows() {
  using S = BucklingResult;
  const auto is_bound = [](const S& buckling) {
    return buckling.is_lower_bound();
  };
  return {
      quantity<S>({"buckling_factor", "/factor", "1", "buckling_factor",
                   kPureNumberRule},
                  &S::factor),
      // It decides, and falls alone where the factor is a bound.
      quantity<S>({"buckling_low", "/band/0", "1", "buckling_low",
                   kPureNumberRule, Since::kLater},
                  buckling_band(&S::band_low)),
      quantity<S>({"buckling_high", "/band/1", "1", "buckling_high"},
                  buckling_band(&S::band_high)),
      quantity<S>({"buckling_is_lower_bound", "/is_lower_bound"}, is_bound),
      quantity<S>({"buckling_instant", "/instant_s", "s"}, &S::instant),
      quantity<S>({"buckling_case", "/case", "", "buckling_case"}, &S::label),
      quantity<S>({"buckling_model", "/model"}, &S::model),
      quantity<S>({"buckling_remark", "/remark"}, &S::remark),
      quantity<S>({"euler", "/euler", "1"}, &S::euler),
  };
}

Quantities<SecondOrderResult> second_order_rows() {
  using S = SecondOrderResult;
  return {
      quantity<S>({"second_order_peak", "/peak_MPa", "MPa", "second_order_peak",
                   kStressRule, Since::kLater},
                  &S::peak),
      quantity<S>({"second_order_stress", "/stress_ratio", "1"}, &S::stress),
      quantity<S>({"second_order_deflection", "/deflection_mm", "mm",
                   "second_order_deflection", kLengthRule, Since::kLater},
                  &S::deflection),
      quantity<S>({"second_order_deflection_ratio", "/deflection_ratio", "1"},
                  &S::deflection_rise),
      quantity<S>({"second_order_is_stable", "/is_stable"}, &S::is_stable),
      quantity<S>({"second_order_bears_growth", "/bears_growth"},
                  &S::bears_growth),
      quantity<S>({"second_order_bound", "/bound_MPa", "MPa"}, &S::bound),
      quantity<S>(
          {"second_order_deflection_bound", "/deflection_bound_mm", "mm"},
          &S::deflection_bound),
      quantity<S>({"second_order_failure", "/failure"}, &S::failure),
      quantity<S>({"second_order_case", "/case"}, &S::label),
  };
}

Quantities<FiniteMotion> finite_motion_rows() {
  using S = FiniteMotion;
  return {
      quantity<S>({"rotation", "/rotation_deg", "deg", "rotation"},
                  &S::rotation),
      quantity<S>({"strain", "/strain_percent", "%"}, &S::strain),
      quantity<S>({"finite_motion_case", "/case"}, &S::label),
  };
}

Quantities<BeamComparison> beam_rows() {
  using S = BeamComparison;
  return {
      quantity<S>(
          {"beam_stress", "/peak_stress_MPa", "MPa", "beam_stress", kBeamRule},
          &S::peak_stress),
      quantity<S>({"beam_governing", "/governing", "", "beam_governing"},
                  &S::governing),
      quantity<S>({"beam_deflection", "/deflection_mm", "mm", "beam_deflection",
                   like_beam_stress(1e-9)},
                  &S::deflection),
      quantity<S>({"buckling_safety", "/buckling_safety", "1", "euler_factor",
                   like_beam_stress(0.0)},
                  &S::buckling_safety),
      quantity<S>(
          {"ratio_fe_to_beam", "/ratio_fe_to_beam", "1", "ratio_fe_to_beam"},
          &S::ratio_fe_to_beam),
      quantity<S>({"ratio_reason", "/reason", "", "ratio_reason"}, &S::reason),
  };
}

Quantities<SelfChecks> self_check_rows() {
  using S = SelfChecks;
  return {
      quantity<S>({"equilibrium", "/equilibrium", "1"}, &S::equilibrium),
      quantity<S>({"residual", "/residual", "1"}, &S::residual),
      quantity<S>({"energy", "/energy", "1"}, &S::energy),
      quantity<S>({"compression", "/compression", "1"}, &S::compression),
      quantity<S>(
          {"reported_peak_is_field_maximum", "/reported_peak_is_field_maximum"},
          &S::reported_peak_is_field_maximum),
  };
}

Quantities<PartSeconds> second_rows() {
  using S = PartSeconds;
  return {
      quantity<S>({"mesh_seconds", "/mesh", "s"}, &S::mesh),
      quantity<S>({"choose_seconds", "/choose", "s"}, &S::choose),
      quantity<S>({"assemble_seconds", "/assemble", "s"}, &S::assemble),
      quantity<S>({"factor_seconds", "/factor", "s"}, &S::factor),
      quantity<S>({"solve_seconds", "/solve", "s"}, &S::solve),
      quantity<S>({"recover_seconds", "/recover", "s"}, &S::recover),
      quantity<S>({"write_seconds", "/write", "s"}, &S::write),
      quantity<S>({"seconds", "/total", "s", "seconds"}, &S::total),
  };
}

/// Identity of the part, and its verdict.
Quantities<PartResult> head_rows() {
  using S = PartResult;
  const auto verdict = [](const S& part) {
    return part::text(part.verdict);
  };
  return {
      quantity<S>({"name", "/name", "", "part"}, &S::name),
      quantity<S>({"verdict", "/verdict", "", "verdict", kVerdictRule},
                  verdict),
      quantity<S>({"why", "/why", "", "why"}, &S::why),
      quantity<S>({"model", "/model", "", "model", kModelRule}, &S::model),
      quantity<S>({"engine", "/engine", "", "engine"}, &S::engine),
      quantity<S>({"engine_why", "/engine_why"}, &S::engine_why),
      quantity<S>(
          {"stopped_because", "/stopped_because", "", "stopped_because"},
          &S::stopped_because),
      quantity<S>({"dofs", "/dofs", "", "dofs"}, &S::dofs),
      quantity<S>({"cells", "/cells", "", "cells"}, &S::cells),
      quantity<S>({"load_columns", "/load_columns"}, &S::load_columns),
      quantity<S>({"mass", "/mass_kg", "kg", "mass", kMassRule}, &S::mass),
  };
}

/// Quantities that follow from the displacements.
Quantities<PartResult> answer_rows() {
  using S = PartResult;
  return {
      quantity<S>({"safety_factor", "/safety_factor", "1", "safety_factor",
                   kPureNumberRule},
                  &S::safety_factor),
      quantity<S>(
          {"deflection", "/deflection_mm", "mm", "deflection", kLengthRule},
          &S::deflection),
      quantity<S>({"deflection_low", "/deflection_band_mm/0", "mm",
                   "deflection_low", kLengthRule, Since::kLater},
                  &S::deflection_low),
      quantity<S>({"deflection_high", "/deflection_band_mm/1", "mm",
                   "deflection_high", kLengthRule, Since::kLater},
                  &S::deflection_high),
      quantity<S>({"deflection_position", "/deflection_at_mm", "mm"},
                  &S::deflection_at),
      quantity<S>({"deflection_instant", "/deflection_instant_s", "s"},
                  &S::deflection_instant),
      quantity<S>({"strain_energy", "/strain_energy_mJ", "mJ", "strain_energy",
                   like_the_peak(1e-9)},
                  &S::strain_energy),
      quantity<S>({"strain_energy_instant", "/strain_energy_J/at_s", "s",
                   "strain_energy_instant", kInstantRule, Since::kLater},
                  &S::strain_energy_instant),
      quantity<S>({"mean_strain_energy", "/strain_energy_J/mean", "J",
                   "mean_strain_energy", like_the_peak(1e-12), Since::kLater},
                  &S::mean_strain_energy),
      quantity<S>({"strain_energy_error", "/strain_energy_error_percent", "%"},
                  &S::strain_energy_error),
  };
}

/// Of the corrected beam-theory model of a blow.
Quantities<PartResult> beam_impact_rows() {
  using S = PartResult;
  return {
      quantity<S>({"beam_impact_factor", "/beam/impact_factor", "1"},
                  [](const S& part) {
                    return beam_impact(part).factor;
                  }),
      quantity<S>({"beam_impact_stress", "/beam/impact_stress_MPa", "MPa"},
                  [](const S& part) {
                    return beam_impact(part).stress;
                  }),
  };
}

Quantities<PartResult> part_rows() {
  using S = PartResult;
  Quantities<S> rows = head_rows();
  add_member_rows(peak_quantities(), "/peak_von_mises", &S::peak, rows);
  add_outside_peak(rows);
  add_rows_of(
      section_quantities(), "/support_section", true,
      [](const S& part) {
        return part.held ? &*part.held : nullptr;
      },
      rows);
  append(answer_rows(), rows);
  add_member_rows(finite_motion_rows(), "/finite_motion", &S::finite_motion,
                  rows);
  add_rows_of(
      buckling_rows(), "/buckling", true,
      [](const S& part) {
        return part.buckling.is_known() ? &part.buckling : nullptr;
      },
      rows);
  add_rows_of(
      second_order_rows(), "/second_order", true,
      [](const S& part) {
        const SecondOrderResult& found = part.second_order;
        const bool is_open = !found.is_stable || !found.bears_growth ||
                             !found.failure.empty() || found.bound > 0.0 ||
                             found.deflection_bound > 0.0;
        return found.peak > 0.0 || is_open ? &found : nullptr;
      },
      rows);
  add_member_rows(beam_rows(), "/beam", &S::beam, rows);
  append(beam_impact_rows(), rows);
  add_member_rows(self_check_rows(), "/self_checks", &S::self_checks, rows);
  add_member_rows(second_rows(), "/seconds", &S::seconds, rows);
  return rows;
}

}  // namespace

const Quantities<PartResult>& part_quantities() {
  static const Quantities<PartResult> rows = part_rows();
  return rows;
}

}  // namespace clevis::report
