#include "report/variants/collection_figure.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "report/figures/svg.h"

namespace clevis::report {
namespace {

// Pixels.
constexpr double kPanelWidth = 330, kPanelHeight = 250;
constexpr double kLeft = 58, kRight = 14, kTop = 26, kBottom = 44;
constexpr double kTitleHeight = 34, kLegendHeight = 30;

constexpr double kMegapascal = 1e6;

struct Point {
  double x{};
  Banded peak;                  ///< [MPa]
  std::optional<double> limit;  ///< [MPa]
  part::Verdict verdict{};
};

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

std::vector<Point> points_of(const Collection& collection,
                             const std::string& path, const std::string& name) {
  const auto xs = abscissae(collection, path);
  std::vector<Point> points;
  for (std::size_t v = 0; v < xs.size(); ++v) {
    for (const VariantPart& part : collection.variants[v].parts) {
      if (part.name != name) continue;
      Point point{xs[v],
                  {part.peak.value / kMegapascal, part.peak.low / kMegapascal,
                   part.peak.high / kMegapascal},
                  std::nullopt,
                  part.verdict};
      if (part.safety_wanted) {
        point.limit =
            point.peak.value * part.safety_factor / *part.safety_wanted;
      }
      points.push_back(point);
    }
  }
  return points;
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

std::string drawn_axes(const svg::Axis& x, const svg::Axis& y,
                       const std::string& title, const std::string& x_label) {
  std::string out;
  for (const double value : svg::ticks(x)) {
    const double at = x.at(value);
    out += svg::line(at, y.begin, at, y.end, "#dddddd") +
           svg::text(at, y.begin + 15, "text-anchor=\"middle\"",
                     fmt::format("{:.6g}", value));
  }
  for (const double value : svg::ticks(y)) {
    const double at = y.at(value);
    out += svg::line(x.begin, at, x.end, at, "#dddddd") +
           svg::text(x.begin - 5, at + 4, "text-anchor=\"end\"",
                     fmt::format("{:.6g}", value));
  }
  return out +
         svg::text(0.5 * (x.begin + x.end), y.begin + 32,
                   "text-anchor=\"middle\"", x_label) +
         svg::text(x.begin, y.end - 7, "font-weight=\"bold\"", title);
}

std::string drawn_points(const std::vector<Point>& points, const svg::Axis& x,
                         const svg::Axis& y) {
  std::string out;
  for (const Point& point : points) {
    const double at = x.at(point.x);
    const char* colour = colour_of(point.verdict);
    out +=
        svg::line(at, y.at(point.peak.low), at, y.at(point.peak.high), colour) +
        fmt::format(
            "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\" fill=\"{}\"/>\n", at,
            y.at(point.peak.value), colour);
  }
  return out;
}

std::string drawn_limit(const std::vector<Point>& points, const svg::Axis& x,
                        const svg::Axis& y) {
  const auto limited = std::ranges::find_if(points, [](const Point& point) {
    return point.limit.has_value();
  });
  if (limited == points.end() || *limited->limit > y.high) return {};
  const double at = y.at(*limited->limit);
  return fmt::format(
      "<path d=\"M{:.1f} {:.1f}H{:.1f}\" stroke=\"#000000\" "
      "stroke-dasharray=\"5 4\"/>\n",
      x.begin, at, x.end);
}

std::string drawn_panel(const std::vector<Point>& points, double left,
                        double top, const std::string& title,
                        const std::string& x_label) {
  const auto [first, last] = std::ranges::minmax(points, {}, &Point::x);
  double low = points[0].peak.low;
  double high = points[0].peak.high;
  for (const Point& point : points) {
    low = std::min({low, point.peak.low, point.limit.value_or(low)});
    high = std::max({high, point.peak.high, point.limit.value_or(high)});
  }
  const svg::Axis x = svg::fitted_axis(first.x, last.x, left + kLeft,
                                       left + kPanelWidth - kRight);
  const svg::Axis y =
      svg::fitted_axis(low, high, top + kPanelHeight - kBottom, top + kTop);
  return drawn_axes(x, y, title, x_label) + drawn_limit(points, x, y) +
         drawn_points(points, x, y);
}

std::string legend(double y) {
  std::string out;
  double x = kLeft;
  for (const auto verdict : {part::Verdict::kPass, part::Verdict::kFail,
                             part::Verdict::kNotJudged}) {
    out += fmt::format(
               "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"{}\"/>\n", x,
               y - 4.0, colour_of(verdict)) +
           svg::text(x + 9.0, y, "", std::string(part::text(verdict)));
    x += 90.0;
  }
  return out + svg::text(x, y, "",
                         "bars: band of the peak; dashed: yield strength over "
                         "the safety factor wanted");
}

}  // namespace

std::string collection_figure(const Collection& collection) {
  const auto paths = collection.paths();
  const auto names = collection.part_names();
  std::string content;
  for (std::size_t row = 0; row < names.size(); ++row) {
    for (std::size_t column = 0; column < paths.size(); ++column) {
      const auto points = points_of(collection, paths[column], names[row]);
      const std::string unit = unit_of(collection, paths[column]);
      content += drawn_panel(points, double(column) * kPanelWidth,
                             kTitleHeight + double(row) * kPanelHeight,
                             fmt::format("{}: peak, MPa", names[row]),
                             unit.empty()
                                 ? paths[column]
                                 : fmt::format("{}, {}", paths[column], unit));
    }
  }
  const double bottom = kTitleHeight + double(names.size()) * kPanelHeight;
  const double columns = std::max(2.0, double(paths.size()));
  return svg::page(columns * kPanelWidth, bottom + kLegendHeight,
                   collection.scene + ", variants",
                   content + legend(bottom + 18.0));
}

}  // namespace clevis::report
