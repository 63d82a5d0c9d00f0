#include "report/machine/bearing_output.h"

#include <numbers>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "part/verdict.h"
#include "report/machine/bearing_quantities.h"
#include "report/quantities/quantity_json.h"
#include "report/text/csv_field.h"
#include "report/text/text_table.h"

namespace clevis::report {
namespace {

using machine::BearingResult;
using nlohmann::ordered_json;
using part::Verdict;

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kHour = 3600.0;

std::optional<double> hours(const std::optional<double>& seconds) {
  if (!seconds) return std::nullopt;
  return *seconds / kHour;
}

/// A life or safety without bound shows as "-".
std::string or_dash(const std::optional<double>& value) {
  return value ? fmt::format("{:.4g}", *value) : "-";
}

std::vector<TextTable::Cell> row(const BearingReport& bearing) {
  const BearingResult& r = bearing.result;
  return {{r.name},
          {bearing.joint},
          {machine::name_of(r.kind)},
          {fmt::format("{:.6g}", r.mean_load)},
          {fmt::format("{:.6g}", r.static_load)},
          {or_dash(r.static_safety)},
          {fmt::format("{:.2f}", r.swing / kDegree)},
          {fmt::format("{:.2f}", r.travel / kDegree)},
          {or_dash(r.life)},
          {or_dash(r.life_cycles)},
          {or_dash(hours(r.life_seconds))},
          {fmt::format("{:.1e}", r.life_error)},
          {std::string(text(r.verdict)), tone_of(r.verdict)}};
}

ordered_json bearing_json(const BearingReport& bearing) {
  ordered_json json = quantities_json(bearing, bearing_quantities());
  ordered_json warnings = ordered_json::array();
  for (const auto& warning : bearing.result.warnings) {
    warnings.push_back({{"code", warning.code}, {"text", warning.text}});
  }
  json["warnings"] = warnings;
  return json;
}

}  // namespace

std::vector<BearingReport> bearing_reports(
    const std::vector<BearingResult>& results,
    const mechanism::MechanismDefinition& definition) {
  std::vector<BearingReport> reports;
  for (const BearingResult& result : results) {
    reports.push_back(
        {result,
         definition.joints[static_cast<std::size_t>(result.joint)].name});
  }
  return reports;
}

std::string bearings_text(const std::vector<BearingReport>& bearings,
                          Colour colour) {
  if (bearings.empty()) return {};
  TextTable table({{"bearing"},
                   {"joint"},
                   {"kind"},
                   {"P_m N", Align::kRight},
                   {"P0 N", Align::kRight},
                   {"C0/P0", Align::kRight},
                   {"swing deg", Align::kRight},
                   {"travel deg", Align::kRight},
                   {"L10 rev", Align::kRight},
                   {"L10 cycles", Align::kRight},
                   {"L10 h", Align::kRight},
                   {"sampling", Align::kRight},
                   {"verdict"}});
  for (const BearingReport& bearing : bearings) {
    table.add_row(row(bearing));
    for (const auto& warning : bearing.result.warnings) {
      table.add_note(fmt::format("{}: {}: {}", bearing.result.name,
                                 warning.code, warning.text));
    }
    if (!bearing.result.why.empty()) {
      table.add_note(fmt::format("{}: {}: {}", bearing.result.name,
                                 text(bearing.result.verdict),
                                 bearing.result.why));
    }
  }
  table.add_note(
      "a cycle is the motion; sampling: relative change of L10 when every "
      "second instant is left out");
  return table.text(colour);
}

ordered_json bearings_json(const std::vector<BearingReport>& bearings) {
  ordered_json list = ordered_json::array();
  for (const BearingReport& bearing : bearings) {
    list.push_back(bearing_json(bearing));
  }
  return list;
}

std::string bearings_csv(const std::vector<BearingReport>& bearings) {
  std::string titles, rows;
  for (const BearingReport& bearing : bearings) {
    std::string line;
    titles.clear();
    const ordered_json json = bearing_json(bearing);
    for (const auto& [key, value] : json.items()) {
      std::string text = value.is_string() ? value.get<std::string>()
                         : value.is_null() ? ""
                                           : value.dump();
      if (key == "warnings") {
        text.clear();
        for (const auto& warning : bearing.result.warnings) {
          if (!text.empty()) text += ' ';
          text += warning.code;
        }
      }
      if (!titles.empty()) {
        titles += ',';
        line += ',';
      }
      titles += key;
      line += csv_field(text);
    }
    rows += line;
    rows += '\n';
  }
  titles += '\n';
  return titles + rows;
}

}  // namespace clevis::report
