#include "study/svg_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "report/figures/svg.h"

namespace clevis::study {
namespace {

namespace svg = report::svg;

// Pixels.
constexpr double kPanelWidth = 480, kPanelHeight = 360;
constexpr double kLeft = 66, kRight = 24, kTop = 34, kBottom = 50;
constexpr double kTitleHeight = 34, kLegendLine = 20;

/// Colours that stay apart for colour-blind readers (Okabe and Ito, 2008).
constexpr std::array<const char*, 8> kColours = {
    "#0072b2", "#d55e00", "#009e73", "#cc79a7",
    "#000000", "#e69f00", "#56b4e9", "#8c6d31"};

bool is_shown(const PlotPoint& p) {
  return p.x > 0.0 && p.y > 0.0 && std::isfinite(p.x) && std::isfinite(p.y);
}

/// A logarithmic axis onto pixels.
struct Axis {
  double low{}, high{};   ///< decimal logarithms
  double begin{}, end{};  ///< pixels
  double at(double value) const {
    return begin + (std::log10(value) - low) / (high - low) * (end - begin);
  }
};

/// Ends of the axis around the values, a little beyond them.
Axis fitted(double least, double most, double begin, double end) {
  constexpr double kMargin = 0.08;  // of the range
  constexpr double kLeastRange = 1.0;
  double low = std::log10(least);
  double high = std::log10(most);
  const double missing = kLeastRange - (high - low);
  if (missing > 0.0) {
    low -= 0.5 * missing;
    high += 0.5 * missing;
  }
  const double margin = kMargin * (high - low);
  return {low - margin, high + margin, begin, end};
}

/// 0.001, 0.1, 1, 10, 1000, 1e6: short for a reader.
std::string tick_label(double value) {
  return value >= 9.99e-5 && value <= 1.01e5 ? fmt::format("{:g}", value)
                                             : fmt::format("{:.0e}", value);
}

/// 1, 2 and 5 of each decade if the axis is short, else the decades.
std::vector<double> ticks(const Axis& axis) {
  constexpr double kShort = 2.0, kLong = 7.0;
  const double range = axis.high - axis.low;
  std::vector<double> values;
  const int step = range > kLong ? 2 : 1;
  for (int d = static_cast<int>(std::floor(axis.low));
       d <= static_cast<int>(std::ceil(axis.high)); ++d) {
    if (d % step != 0) continue;
    for (const double factor : {1.0, 2.0, 5.0}) {
      if (factor > 1.0 && range > kShort) continue;
      const double value = factor * std::pow(10.0, d);
      const double log = std::log10(value);
      if (log >= axis.low && log <= axis.high) values.push_back(value);
    }
  }
  return values;
}

std::string marker(double x, double y, std::size_t style) {
  const char* colour = kColours[style % kColours.size()];
  constexpr double r = 4.0;
  switch (style % 4) {
    case 0:
      return fmt::format(
          "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"{}\"/>\n", x, y,
          r, colour);
    case 1:
      return fmt::format(
          "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{}\" height=\"{}\" "
          "fill=\"{}\"/>\n",
          x - 0.9 * r, y - 0.9 * r, 1.8 * r, 1.8 * r, colour);
    case 2:
      return fmt::format("<path d=\"M{:.1f} {:.1f}l{} {}h{}z\" fill=\"{}\"/>\n",
                         x, y - 1.2 * r, 1.15 * r, 2.0 * r, -2.3 * r, colour);
    default:
      return fmt::format(
          "<path d=\"M{:.1f} {:.1f}l{} {}l{} {}l{} {}z\" fill=\"{}\"/>\n", x,
          y - 1.3 * r, 1.3 * r, 1.3 * r, -1.3 * r, 1.3 * r, -1.3 * r, -1.3 * r,
          colour);
  }
}

std::string drawn_series(const PlotSeries& series, std::size_t style,
                         const Axis& x, const Axis& y) {
  constexpr double kCrowded = 14.0;  // labels this near hide each other
  std::string path, points;
  double last_x = -kCrowded;
  double last_y = -kCrowded;
  for (const PlotPoint& p : series.points) {
    if (!is_shown(p)) continue;
    const double px = x.at(p.x);
    const double py = y.at(p.y);
    const bool is_clear = std::hypot(px - last_x, py - last_y) > kCrowded;
    last_x = px;
    last_y = py;
    path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", px, py);
    points += marker(px, py, style);
    if (!p.label.empty() && is_clear) {
      points += fmt::format(
          "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"10\" fill=\"{}\">{}"
          "</text>\n",
          px + 6.0, py - 5.0, kColours[style % kColours.size()],
          svg::escaped(p.label));
    }
  }
  return fmt::format(
             "<path d=\"{}\" fill=\"none\" stroke=\"{}\" "
             "stroke-width=\"1.5\"/>\n",
             path, kColours[style % kColours.size()]) +
         points;
}

std::string drawn_axes(const Panel& panel, const Axis& x, const Axis& y) {
  std::string out;
  for (const double value : ticks(x)) {
    const double at = x.at(value);
    out += svg::line(at, y.begin, at, y.end, "#dddddd") +
           svg::text(at, y.begin + 16, "text-anchor=\"middle\"",
                     tick_label(value));
  }
  for (const double value : ticks(y)) {
    const double at = y.at(value);
    out += svg::line(x.begin, at, x.end, at, "#dddddd") +
           svg::text(x.begin - 6, at + 4, "text-anchor=\"end\"",
                     tick_label(value));
  }
  out += fmt::format(
      "<path d=\"M{0:.1f} {1:.1f}H{2:.1f}V{3:.1f}H{0:.1f}z\" fill=\"none\" "
      "stroke=\"#444444\"/>\n",
      x.begin, y.begin, x.end, y.end);
  const double middle = 0.5 * (y.begin + y.end);
  out += svg::text(0.5 * (x.begin + x.end), y.begin + 36,
                   "text-anchor=\"middle\"", panel.x_label) +
         fmt::format(
             "<text transform=\"translate({:.1f},{:.1f}) rotate(-90)\" "
             "text-anchor=\"middle\">{}</text>\n",
             x.begin - 48, middle, svg::escaped(panel.y_label)) +
         svg::text(x.begin, y.end - 8, "font-weight=\"bold\"", panel.title);
  return out;
}

/// Draws the reference's own uncertainty in grey.
std::string drawn_floor(double floor, const Axis& x, const Axis& y) {
  if (!(floor > 0.0) || std::log10(floor) <= y.low) return {};
  const double top = std::max(y.at(floor), y.end);
  return fmt::format(
             "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" "
             "height=\"{:.1f}\" fill=\"#eeeeee\"/>\n",
             x.begin, top, x.end - x.begin, y.begin - top) +
         svg::text(x.end - 6, y.begin - 6,
                   "text-anchor=\"end\" font-size=\"10\" fill=\"#777777\"",
                   "within the reference's own uncertainty");
}

bool is_empty(const Panel& panel) {
  return std::ranges::none_of(panel.series, [](const PlotSeries& s) {
    return std::ranges::any_of(s.points, is_shown);
  });
}

std::string drawn_panel(const Panel& panel, double left, double top,
                        const std::vector<std::string>& names) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  PlotPoint low{kInfinite, kInfinite, {}};
  PlotPoint high{0.0, 0.0, {}};
  for (const auto& series : panel.series) {
    for (const auto& p : series.points) {
      if (!is_shown(p)) continue;
      low = {std::min(low.x, p.x), std::min(low.y, p.y), {}};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), {}};
    }
  }
  const Axis x =
      fitted(low.x, high.x, left + kLeft, left + kPanelWidth - kRight);
  const Axis y =
      fitted(low.y, high.y, top + kPanelHeight - kBottom, top + kTop);
  std::string out = drawn_floor(panel.floor, x, y) + drawn_axes(panel, x, y);
  for (const auto& series : panel.series) {
    const auto style = static_cast<std::size_t>(
        std::ranges::find(names, series.name) - names.begin());
    out += drawn_series(series, style, x, y);
  }
  return out;
}

std::vector<std::string> series_names(const std::vector<Panel>& panels) {
  std::vector<std::string> names;
  for (const auto& panel : panels) {
    for (const auto& series : panel.series) {
      const bool has_points = std::ranges::any_of(series.points, is_shown);
      if (has_points && std::ranges::find(names, series.name) == names.end()) {
        names.push_back(series.name);
      }
    }
  }
  return names;
}

}  // namespace

std::string svg_figure(const std::string& title,
                       const std::vector<Panel>& panels, int columns) {
  constexpr double kCharacter = 7.0, kKey = 34.0;
  std::vector<Panel> shown = panels;
  std::erase_if(shown, is_empty);
  const auto names = series_names(shown);
  const int across =
      std::max(1, std::min(columns, static_cast<int>(shown.size())));
  const int down = (static_cast<int>(shown.size()) + across - 1) / across;
  const double width = across * kPanelWidth;
  std::string legend;
  double x = kLeft;
  double y = kTitleHeight + down * kPanelHeight + kLegendLine;
  for (std::size_t s = 0; s < names.size(); ++s) {
    const double taken =
        kKey + kCharacter * static_cast<double>(names[s].size());
    if (x > kLeft && x + taken > width - kRight) {
      x = kLeft;
      y += kLegendLine;
    }
    legend +=
        svg::line(x, y - 4, x + 20, y - 4, kColours[s % kColours.size()]) +
        marker(x + 10, y - 4, s) + svg::text(x + 26, y, "", names[s]);
    x += taken;
  }
  const double height = y + kLegendLine;
  std::string out;
  for (std::size_t p = 0; p < shown.size(); ++p) {
    const int index = static_cast<int>(p);
    out += drawn_panel(shown[p], index % across * kPanelWidth,
                       kTitleHeight + index / across * kPanelHeight, names);
  }
  return svg::page(width, height, title, out + legend);
}

}  // namespace clevis::study
