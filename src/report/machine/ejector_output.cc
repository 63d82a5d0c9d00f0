#include "report/machine/ejector_output.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "report/text/atomic_file.h"
#include "report/text/csv_field.h"
#include "report/text/json_text.h"
#include "report/text/text_table.h"
#include "report/text/units.h"

namespace clevis::report {
namespace {

using beam::EjectorDrive;
using beam::EjectorVariant;
using nlohmann::ordered_json;

constexpr double kMegapascal = 1e6, kMillimetre = 1e-3;

std::string drive_text(const EjectorDrive& drive) {
  return drive.pusher_speed
             ? fmt::format("{:.4f} m/s", *drive.pusher_speed)
             : fmt::format("does not arrive (energy {:.4g} J)", drive.energy);
}

std::string or_any(const std::optional<double>& value, double unit,
                   const char* name) {
  if (!value) return "any";
  if (*value == 0.0) return "none";
  return fmt::format("{:.4g} {}", *value / unit, name);
}

std::string stress_text(const std::optional<double>& stress,
                        const EjectorDrive& drive) {
  if (stress) return fmt::format("{:.1f} MPa", *stress / kMegapascal);
  return drive.pusher_speed ? "none, the spring holds the pusher back"
                            : "none, the pusher does not arrive";
}

/// What tells of a wrong unit.
std::vector<std::string> notes_on(const EjectorResult& r) {
  constexpr double kFast = 100.0, kHopeless = 100.0;  // [m/s], [1]
  std::vector<std::string> notes;
  const auto& speed = r.corrected.pusher_speed;
  if (!speed) {
    notes.push_back(
        "the pusher does not arrive, nothing is struck: see that the spring's "
        "preset and stiffness, the magnet's force and the arms are right");
  } else if (*speed > kFast) {
    notes.push_back(fmt::format(
        "the pusher strikes at {:.4g} m/s: see that the units of its inertia, "
        "of the magnet's force and of the arms are right",
        *speed));
  }
  double most = 0.0;
  for (const EjectorVariant& v : r.variants) {
    if (v.impact) most = std::max(most, v.impact->stress);
  }
  if (most > kHopeless * r.limits.stress) {
    notes.push_back(fmt::format(
        "the blow would need {:.3g} times the stress that is allowed: see that "
        "the units of the workpiece's diameter and length are right",
        most / r.limits.stress));
  }
  return notes;
}

std::string one_text(const EjectorResult& r, Colour colour) {
  std::string text = printable(r.name);
  text += fmt::format(
      "\npusher: {:.4g} kg, pushes with {:.4g} N; V_B {} by the work of the "
      "forces, {} as published\n",
      r.corrected.pusher_mass, r.corrected.pusher_force,
      drive_text(r.corrected), drive_text(r.published));
  TextTable table({{"formulas"},
                   {"V m/s", Align::kRight},
                   {"static MPa", Align::kRight},
                   {"factor", Align::kRight},
                   {"stress MPa", Align::kRight},
                   {"deflection mm", Align::kRight}});
  for (const EjectorVariant& v : r.variants) {
    if (!v.impact) {
      table.add_row({{v.name}, {""}, {""}, {""}, {"-"}, {"-"}});
      continue;
    }
    const beam::BarImpact& i = *v.impact;
    table.add_row({{v.name},
                   {fmt::format("{:.4f}", v.speed)},
                   {fmt::format("{:.3f}", i.static_stress / kMegapascal)},
                   {i.factor ? fmt::format("{:.1f}", *i.factor) : "-"},
                   {fmt::format("{:.1f}", i.stress / kMegapascal)},
                   {fmt::format("{:.3f}", i.deflection / kMillimetre)}});
  }
  text += table.text(colour);
  text += fmt::format(
      "formula (6): {}; as printed, with J_C twice: {}\n"
      "largest for {:.4g} MPa: magnet force {}, travel {}, magnet's range {}, "
      "speed {:.4g} m/s\n",
      stress_text(r.condition_corrected, r.published),
      stress_text(r.condition_published, r.published),
      r.limits.stress / kMegapascal, or_any(r.limits.magnet_force, 1.0, "N"),
      or_any(r.limits.travel, kMillimetre, "mm"),
      or_any(r.limits.range, kMillimetre, "mm"), r.limits.speed);
  return text + note_lines(notes_on(r));
}

ordered_json or_null(const std::optional<double>& value, double unit = 1.0) {
  return value ? ordered_json(*value / unit) : ordered_json();
}

ordered_json drive_json(const EjectorDrive& drive) {
  return {{"pusher_mass_kg", drive.pusher_mass},
          {"pusher_force_N", drive.pusher_force},
          {"energy_J", drive.energy},
          {"pusher_speed_m_per_s", or_null(drive.pusher_speed)}};
}

ordered_json variant_json(const EjectorVariant& v) {
  ordered_json json = {{"formulas", v.name}, {"speed_m_per_s", v.speed}};
  if (!v.impact) return json;
  json["static_stress_MPa"] = v.impact->static_stress / kMegapascal;
  json["static_deflection_mm"] = v.impact->static_deflection / kMillimetre;
  json["factor"] = or_null(v.impact->factor);
  json["stress_MPa"] = v.impact->stress / kMegapascal;
  json["deflection_mm"] = v.impact->deflection / kMillimetre;
  return json;
}

ordered_json one_json(const EjectorResult& r) {
  ordered_json variants = ordered_json::array();
  for (const EjectorVariant& v : r.variants) {
    variants.push_back(variant_json(v));
  }
  return {{"name", r.name},
          {"drive", drive_json(r.corrected)},
          {"drive_published", drive_json(r.published)},
          {"variants", variants},
          {"condition_6_MPa", or_null(r.condition_corrected, kMegapascal)},
          {"condition_6_published_MPa",
           or_null(r.condition_published, kMegapascal)},
          {"largest",
           {{"stress_MPa", r.limits.stress / kMegapascal},
            {"magnet_force_N", or_null(r.limits.magnet_force)},
            {"travel_mm", or_null(r.limits.travel, kMillimetre)},
            {"range_mm", or_null(r.limits.range, kMillimetre)},
            {"speed_m_per_s", r.limits.speed}}},
          {"notes", notes_on(r)}};
}

}  // namespace

EjectorResult ejector_result(const machine::EjectorDefinition& ejector) {
  using beam::Formula;
  return {.name = ejector.name,
          .published = beam::ejector_drive(ejector, Formula::kPublished),
          .corrected = beam::ejector_drive(ejector),
          .variants = beam::ejector_variants(ejector),
          .condition_published =
              beam::strength_condition(ejector, Formula::kPublished),
          .condition_corrected =
              beam::strength_condition(ejector, Formula::kCorrected),
          .limits = beam::ejector_limits(ejector)};
}

std::string ejector_text(const EjectorReport& report, Colour colour) {
  std::string text = printable(report.scene);
  text += '\n';
  for (const EjectorResult& result : report.ejectors) {
    text += '\n';
    text += one_text(result, colour);
  }
  return text;
}

std::string ejector_json(const EjectorReport& report) {
  ordered_json list = ordered_json::array();
  for (const EjectorResult& result : report.ejectors) {
    list.push_back(one_json(result));
  }
  const ordered_json json = {{"schema", kSchema},
                             {"version", report.version},
                             {"scene", report.scene},
                             {"ejectors", list}};
  refuse_non_finite(json, "impact");
  return json_text(json);
}

std::string ejector_csv(const EjectorReport& report) {
  std::string text =
      "ejector,formulas,speed_m_per_s,static_stress_MPa,factor,stress_MPa,"
      "deflection_mm\n";
  for (const EjectorResult& result : report.ejectors) {
    for (const EjectorVariant& v : result.variants) {
      text += fmt::format("{},{},{},", csv_field(result.name),
                          csv_field(v.name), v.speed);
      text += v.impact
                  ? fmt::format(
                        "{},{},{},{}\n", v.impact->static_stress / kMegapascal,
                        v.impact->factor ? fmt::format("{}", *v.impact->factor)
                                         : "",
                        v.impact->stress / kMegapascal,
                        v.impact->deflection / kMillimetre)
                  : ",,,\n";
    }
  }
  return text;
}

void write_ejector_files(const EjectorReport& report,
                         const std::filesystem::path& folder) {
  const std::string json = ejector_json(report);  // refuses first
  write_file(folder / "impact.csv", ejector_csv(report));
  write_file(folder / "impact.json", json);
}

}  // namespace clevis::report
