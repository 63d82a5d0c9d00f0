#include "report/variants/collection_figure.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace clevis::report {
namespace {

constexpr double kMegapascal = 1e6;

/// The number that a value starts with.
std::optional<double> number_of(const std::string& value) {
  char* end = nullptr;
  const double number = std::strtod(value.c_str(), &end);
  if (end == value.c_str() || !std::isfinite(number)) return std::nullopt;
  return number;
}

/// Abscissae of the variants for a path: numbers if all are, else counts of the
/// different values.
std::vector<double> abscissae(const Collection& collection,
                              const std::string& path) {
  std::vector<double> numbers, places;
  std::map<std::string, double> place_of;
  for (const Variant& variant : collection.variants) {
    const std::string value = setting_of(variant, path);
    if (const auto number = number_of(value)) numbers.push_back(*number);
    places.push_back(
        place_of.emplace(value, double(place_of.size()) + 1.0).first->second);
  }
  return numbers.size() == places.size() ? numbers : places;
}

/// Unit behind the number of the first value.
std::string unit_of(const Collection& collection, const std::string& path) {
  for (const Variant& variant : collection.variants) {
    const std::string value = setting_of(variant, path);
    char* end = nullptr;
    std::strtod(value.c_str(), &end);
    if (end == value.c_str()) continue;
    const std::string rest = end;
    const std::size_t start = rest.find_first_not_of(' ');
    if (start != rest.npos) return rest.substr(start);
  }
  return {};
}

const char* colour_of(part::Verdict verdict) {
  switch (verdict) {
    case part::Verdict::kPass:
      return "#009e73";
    case part::Verdict::kFail:
      return "#d55e00";
    case part::Verdict::kNotJudged:
      break;
  }
  return "#777777";
}

/// Peaks of a part against a setting, a series per verdict.
PlotPanel panel_of(const Collection& collection, const std::string& path,
                   const std::string& name) {
  const std::string unit = unit_of(collection, path);
  PlotPanel panel{name,
                  unit.empty() ? path : fmt::format("{}, {}", path, unit),
                  "peak, MPa",
                  {}};
  for (const auto verdict : {part::Verdict::kPass, part::Verdict::kFail,
                             part::Verdict::kNotJudged}) {
    panel.series.push_back(
        {std::string(part::text(verdict)), {}, colour_of(verdict)});
  }
  const auto xs = abscissae(collection, path);
  for (std::size_t v = 0; v < xs.size(); ++v) {
    for (const VariantPart& part : collection.variants[v].parts) {
      if (part.name != name) continue;
      const double peak = part.peak.value / kMegapascal;
      std::ranges::find(panel.series, part::text(part.verdict),
                        &PlotSeries::name)
          ->points.push_back({xs[v], peak, part.peak.low / kMegapascal,
                              part.peak.high / kMegapascal});
      if (part.safety_wanted && !panel.limit) {
        panel.limit = peak * part.safety_factor / *part.safety_wanted;
      }
    }
  }
  return panel;
}

}  // namespace

PlotFigure collection_figure(const Collection& collection) {
  const auto paths = collection.paths();
  PlotFigure figure{collection.scene + ", variants",
                    {"bars: band of the peak",
                     "dashed: yield strength over the safety factor wanted"},
                    PlotAxes::kLinear,
                    static_cast<int>(paths.size())};
  for (const std::string& name : collection.part_names()) {
    for (const std::string& path : paths) {
      figure.panels.push_back(panel_of(collection, path, name));
    }
  }
  return figure;
}

}  // namespace clevis::report
