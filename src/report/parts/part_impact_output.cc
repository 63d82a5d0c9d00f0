#include "report/parts/part_impact_output.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "report/parts/impact_quantities.h"
#include "report/quantities/quantity_json.h"
#include "report/text/text_table.h"
#include "report/text/units.h"

namespace clevis::report {
namespace {

using assessment::DurationRatio;
using assessment::ImpactResult;
using assessment::ImpactRow;
using assessment::PartResult;
using nlohmann::ordered_json;

constexpr double kMillisecond = 1e-3, kPercent = 100.0;
constexpr double kMegapascal = 1e6, kMillimetre = 1e-3;

/// @param unit  of the text, in SI.
std::string or_dash(const std::optional<double>& value, double unit,
                    const char* format) {
  return value ? fmt::format(fmt::runtime(format), *value / unit) : "-";
}

std::string head_of(const PartResult& part, const ImpactResult& impact) {
  return printable(fmt::format(
             "impact {} on {} ({}): {:.4g} kg at {:.5g} m/s, pushed by {:.4g} "
             "N, {}{:.4g} N/m{}",
             impact.name, part.name, impact.source, impact.mass, impact.speed,
             impact.force,
             impact.is_ideal ? "ideal step, computed with " : "contact ",
             impact.stiffness, impact.exponent == 1.0 ? "" : "^1.5")) +
         fmt::format(
             "\n  mass ratio {:.3g}; load for {:.4g} ms, {:.3g} periods "
             "of {:.4g} ms along the blow; peak {:.4g} N after {:.3g} ms\n",
             impact.mass / impact.part_mass,
             impact.load_duration / kMillisecond,
             impact.load_duration / impact.first_period,
             impact.first_period / kMillisecond, impact.peak_force,
             impact.rise_time / kMillisecond);
}

/// "stress 330, 345, 361 MPa with fronts of 8, 4, 2 us: …"; empty for blows
/// whose fronts the mesh carries.
std::string refinement_of(const ImpactResult& impact) {
  constexpr double kTold = 1e-3;
  const auto& tried = impact.refinement;
  if (tried.below + tried.above < kTold) return "";
  const auto list = [](const std::vector<double>& values, double unit,
                       const char* format) {
    std::string text;
    for (const double value : values) {
      if (!text.empty()) text += ", ";
      text += fmt::format(fmt::runtime(format), value / unit);
    }
    return text;
  };
  const std::string competing_stress =
      tried.competing_stress.empty()
          ? ""
          : fmt::format(" (for at {:.4g} ms it goes {})",
                        tried.competing_time / kMillisecond,
                        list(tried.competing_stress, 1e6, "{:.4g}"));
  return fmt::format(
      "by p = {} stress {} MPa with fronts of {} us, the last that the mesh "
      "carries: {:.2g} % more{} and {:.2g} % less are left, {}; deflection {} "
      "mm",
      tried.degree, list(tried.stress, 1e6, "{:.4g}"),
      list(tried.fronts, 1e-6, "{:.3g}"), kPercent * tried.above,
      competing_stress, kPercent * tried.below,
      tried.settles ? "settles"
                    : "DOES NOT SETTLE: mesh finer along the wave's way, "
                      "compare deflections, or give the contact its stiffness",
      list(tried.deflection, 1e-3, "{:.4g}"));
}

/// Empty where nothing larger comes.
std::string later_peaks_of(const ImpactResult& impact) {
  constexpr double kSays = 1.005;  // to three digits
  if (std::max({impact.later_stress, impact.later_deflection,
                impact.later_root}) < kSays) {
    return "";
  }
  return fmt::format(
      "later, within {:.4g} ms, stress comes to {:.3g} times, deflection to "
      "{:.3g}, a held section's stress to {:.3g} times these (by few shapes, "
      "in "
      "the bands){}",
      impact.looked_for / kMillisecond, impact.later_stress,
      impact.later_deflection, impact.later_root,
      impact.force > 0.0 ? ": a force presses on, give the part its damping"
                         : "");
}

/// Largest free vibration over the judged value; 0: no more.
double free_vibration_over(const std::optional<double>& vibration,
                           double later) {
  constexpr double kMore = 1.02;
  return vibration.value_or(0.0) > kMore ? *vibration * later : 0.0;
}

std::string free_vibration_of(const ImpactResult& impact) {
  const double stress =
      free_vibration_over(impact.free_vibration_stress, impact.later_stress);
  const double way = free_vibration_over(impact.free_vibration_deflection,
                                         impact.later_deflection);
  if (stress == 0.0 && way == 0.0) return "";
  return fmt::format(
      "without damping its free swing comes to {:#.4g} MPa and {:#.4g} mm at "
      "the most, whenever (sum of its shapes), which is not judged: give the "
      "part its damping",
      megapascals(impact.stress) * std::max(1.0, stress),
      millimetres(impact.deflection) * std::max(1.0, way));
}

std::string table_of(const ImpactResult& impact, Colour colour) {
  TextTable table({{"model"},
                   {"stress MPa", Align::kRight},
                   {"root MPa", Align::kRight},
                   {"/judged", Align::kRight},
                   {"face mm", Align::kRight},
                   {"defl. mm", Align::kRight},
                   {"error %", Align::kRight},
                   {"s", Align::kRight},
                   {""}});
  for (const ImpactRow& row : impact.rows) {
    table.add_row({{model_name(row)},
                   {or_dash(row.stress, kMegapascal, "{:.1f}")},
                   {or_dash(row.nominal, kMegapascal, "{:.1f}")},
                   {or_dash(row.ratio, 1.0, "{:.3f}")},
                   {fmt::format("{:.4f}", millimetres(row.face))},
                   {or_dash(row.deflection, kMillimetre, "{:.4f}")},
                   {or_dash(row.error, 1.0 / kPercent, "{:.2g}")},
                   {fmt::format("{:.2g}", row.seconds)},
                   {row.remark}});
  }
  table.add_note(fmt::format(
      "stress {:#.4g} [{:#.4g}, {:#.4g}] MPa, safety {:#.4g}; in time: {}",
      megapascals(impact.stress), megapascals(impact.band_low),
      megapascals(impact.band_high), impact.safety_factor, impact.reason));
  if (impact.root) table.add_note(support_section_text(*impact.root));
  if (impact.spread > 0.0) {
    table.add_note(
        fmt::format("the striker bounces, and its response is chaotic: 2 % of "
                    "its mass change the peaks by {:.2g} %, in the bands{}",
                    kPercent * impact.spread,
                    impact.force > 0.0 ? "; give the part its damping" : ""));
  }
  const std::string later = later_peaks_of(impact);
  if (!later.empty()) table.add_note(later);
  const std::string vibration = free_vibration_of(impact);
  if (!vibration.empty()) table.add_note(vibration);
  const std::string refinement = refinement_of(impact);
  if (!refinement.empty()) table.add_note(refinement);
  return table.text(colour);
}

std::string duration_ratios_text(const PartResult& part) {
  std::string text;
  for (const DurationRatio& rated : part.duration_ratios) {
    text += printable(fmt::format("{}, {}", part.name, rated.impact));
    text += fmt::format(
        ": for {:.4g} ms, {:.3g} of its first period of {:.4g} ms{}; a mode "
        "answers {:.2f} times. {}\n",
        rated.duration / kMillisecond, rated.ratio,
        rated.first_period / kMillisecond,
        rated.rise_time > 0.0 ? fmt::format(", rising for {:.4g} ms",
                                            rated.rise_time / kMillisecond)
                              : "",
        rated.amplification, rated.treatment);
  }
  return text;
}

/// Peak under vibration.
std::string vibration_text(const PartResult& part) {
  const assessment::VibrationResult& v = part.vibration;
  if (!v.is_whole() && !v.ratio) {
    return printable(
        fmt::format("{} with vibration: not computed: {}\n", part.name,
                    v.failure.empty() ? v.not_followed : v.failure));
  }
  if (!v.ratio) return "";
  return fmt::format(
      "{} with vibration: {:#.5g} [{:#.5g}, {:#.5g}] MPa at {} {}, "
      "t = {:.6g} s, {:.3f} of the quasi-static peak\n"
      "  {}, {} shapes of {:.4g} to {:.4g} kHz, {:.6g} s to {:.6g} s; error "
      "{:.2g} % (degree {:.2g}, shapes {:.2g}, samples {:.2g}, instants "
      "{:.2g}); {:.2f} s\n",
      printable(part.name), megapascals(v.peak), megapascals(v.band_low),
      megapascals(v.band_high), v.group, place_text(v.at), v.time, *v.ratio,
      v.model, v.shapes, v.lowest_frequency / 1e3, v.highest_frequency / 1e3,
      v.from, v.to, kPercent * v.error(), kPercent * v.degree_error,
      kPercent * v.shape_error, kPercent * v.sampling_error,
      kPercent * v.path_error, v.seconds);
}

ordered_json refinement_steps(const assessment::WaveFrontRefinement& tried) {
  ordered_json steps = ordered_json::array();
  for (std::size_t i = 0; i < tried.stress.size(); ++i) {
    steps.push_back({{"wave_front_s", tried.fronts[i]},
                     {"stress_MPa", megapascals(tried.stress[i])},
                     {"deflection_mm", millimetres(tried.deflection[i])}});
  }
  return steps;
}

ordered_json blow_json(const ImpactResult& blow) {
  ordered_json json = quantities_json(blow, blow_quantities());
  if (json["refinement"].is_object()) {
    json["refinement"]["steps"] = refinement_steps(blow.refinement);
  }
  json["models"] = ordered_json::array();
  for (const ImpactRow& row : blow.rows) {
    json["models"].push_back(quantities_json(row, blow_model_quantities()));
  }
  return json;
}

}  // namespace

std::string part_impacts_text(const PartResult& part, Colour colour) {
  std::string text;
  for (const ImpactResult& impact : part.impacts) {
    text += "\n" + head_of(part, impact) + table_of(impact, colour);
  }
  if (!part.duration_ratios.empty()) text += "\n" + duration_ratios_text(part);
  text += vibration_text(part);
  return text;
}

ordered_json part_impacts_json(const PartResult& part) {
  ordered_json list = ordered_json::array();
  for (const ImpactResult& blow : part.impacts) list.push_back(blow_json(blow));
  return list;
}

ordered_json duration_ratios_json(const PartResult& part) {
  ordered_json list = ordered_json::array();
  for (const DurationRatio& rated : part.duration_ratios) {
    list.push_back(quantities_json(rated, duration_ratio_quantities()));
  }
  return list;
}

ordered_json vibration_json(const PartResult& part) {
  const auto* vibration = computed_vibration(part);
  ordered_json json;
  if (vibration != nullptr) {
    json = quantities_json(*vibration, vibration_quantities());
  }
  const auto& [failure, not_followed] =
      std::tie(part.vibration.failure, part.vibration.not_followed);
  if (!failure.empty()) json["failure"] = failure;
  if (!not_followed.empty()) json["not_followed"] = not_followed;
  return json;
}

std::string support_section_text(const assessment::SupportStress& held) {
  return fmt::format(
      "section {}, by its support's force and moment: {:#.5g} [{:#.5g}, "
      "{:#.5g}] MPa at {:.4g} ms",
      printable(held.section), megapascals(held.value),
      megapascals(held.band_low), megapascals(held.band_high),
      held.instant / kMillisecond);
}

BeamImpactSummary beam_impact(const PartResult& part) {
  BeamImpactSummary found;
  for (const ImpactResult& impact : part.impacts) {
    for (const ImpactRow& row : impact.rows) {
      if (row.model != assessment::ImpactModel::kBeamCorrected ||
          row.nominal <= found.stress) {
        continue;
      }
      found.stress = row.nominal;
      found.factor = impact.beam_factor;
    }
  }
  return found;
}

}  // namespace clevis::report
