#include "report/figures/plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include <fmt/format.h>

namespace clevis::report {
namespace {

// Pixels.
constexpr double kPanelWidth = 480, kPanelHeight = 360;
constexpr double kLeft = 74, kRight = 24, kTop = 34, kBottom = 50;
constexpr double kTitleHeight = 34, kLegendLine = 20;

/// Colours that stay apart for colour-blind readers (Okabe and Ito, 2008).
constexpr std::array<const char*, 8> kColours = {
    "#0072b2", "#d55e00", "#009e73", "#cc79a7",
    "#000000", "#e69f00", "#56b4e9", "#8c6d31"};
/// gnuplot's numbers of filled markers: circle, square, triangle, diamond.
constexpr std::array<int, 4> kMarkers = {7, 5, 9, 13};

/// A text as a string of gnuplot: what is not plain stands as its octal code,
/// so that nothing in it ends the string, is run (`…`) or expanded (@…).
std::string quoted(std::string_view text) {
  constexpr std::string_view kPlain = " .,:;=+-/%()<>&_";
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                           (c >= '0' && c <= '9');
    if (byte < 0x20 || byte == 0x7f) {
      out += ' ';
    } else if (is_letter || kPlain.find(c) != kPlain.npos) {
      out += c;
    } else {
      out += fmt::format("\\0{:03o}", byte);  // four digits after a 0
    }
  }
  return out + '"';
}

/// A label in a block of data, which knows no codes.
std::string data_text(std::string_view text) {
  std::string out = quoted(text);
  std::ranges::replace(out, '\\', '_');
  return out;
}

/// Ends of an axis, a little beyond its values.
struct Axis {
  double low{}, high{};
  PlotAxes kind{};

  /// Where a value stands on it: 0 to 1.
  double share(double value) const {
    return kind == PlotAxes::kLogarithmic
               ? std::log(value / low) / std::log(high / low)
               : (value - low) / (high - low);
  }
};

Axis fitted_axis(PlotAxes kind, double least, double largest) {
  constexpr double kMargin = 0.08;  // of the range
  if (kind == PlotAxes::kLogarithmic) {
    const double missing = std::max(0.0, 1.0 - std::log10(largest / least));
    const double margin =
        kMargin * std::max(1.0, std::log10(largest / least)) + 0.5 * missing;
    return {least * std::pow(10.0, -margin), largest * std::pow(10.0, margin),
            kind};
  }
  double margin = kMargin * (largest - least);
  if (!(margin > 0.0)) margin = 0.1 * std::abs(least);
  if (!(margin > 0.0)) margin = 1.0;
  return {least - margin, largest + margin, kind};
}

bool is_shown(const PlotPoint& p, PlotAxes kind) {
  const bool is_finite = std::isfinite(p.x) && std::isfinite(p.y) &&
                         std::isfinite(p.low) && std::isfinite(p.high);
  return is_finite &&
         (kind == PlotAxes::kLinear || (p.x > 0.0 && p.y > 0.0 && p.low > 0.0));
}

/// The panels that have points, with these alone.
std::vector<PlotPanel> shown_panels(const PlotFigure& figure) {
  std::vector<PlotPanel> panels = figure.panels;
  for (PlotPanel& panel : panels) {
    for (PlotSeries& series : panel.series) {
      std::erase_if(series.points, [&figure](const PlotPoint& point) {
        return !is_shown(point, figure.axes);
      });
    }
    std::erase_if(panel.series, [](const PlotSeries& series) {
      return series.points.empty();
    });
  }
  std::erase_if(panels, [](const PlotPanel& panel) {
    return panel.series.empty();
  });
  return panels;
}

/// What the legend holds.
struct Style {
  std::string name, colour;
  int marker{};
};
std::vector<Style> styles_of(const std::vector<PlotPanel>& panels) {
  std::vector<Style> styles;
  for (const PlotPanel& panel : panels) {
    for (const PlotSeries& series : panel.series) {
      if (std::ranges::find(styles, series.name, &Style::name) !=
          styles.end()) {
        continue;
      }
      const std::size_t k = styles.size();
      styles.push_back({series.name,
                        series.colour.empty() ? kColours[k % kColours.size()]
                                              : series.colour,
                        kMarkers[(k + k / kColours.size()) % kMarkers.size()]});
    }
  }
  return styles;
}

struct Axes {
  Axis x, y;
};
Axes axes_of(const PlotPanel& panel, PlotAxes kind) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  double left = kInfinite, right = -kInfinite;
  double low = panel.limit.value_or(kInfinite);
  double high = panel.limit.value_or(-kInfinite);
  for (const PlotSeries& series : panel.series) {
    for (const PlotPoint& p : series.points) {
      left = std::min(left, p.x);
      right = std::max(right, p.x);
      low = std::min(low, p.low);
      high = std::max(high, p.high);
    }
  }
  return {fitted_axis(kind, left, right), fitted_axis(kind, low, high)};
}

/// Data of a series: x, y, band, and labels where they do not hide each other.
std::string data_block(const std::string& block, const PlotSeries& series,
                       const Axes& axes) {
  constexpr double kCrowded = 14.0;  // [pixel]
  std::string out = fmt::format("${} << EOD\n", block);
  double last_x = -kCrowded, last_y = -kCrowded;
  for (const PlotPoint& p : series.points) {
    const double x = kPanelWidth * axes.x.share(p.x);
    const double y = kPanelHeight * axes.y.share(p.y);
    const bool is_clear = std::hypot(x - last_x, y - last_y) > kCrowded;
    last_x = x;
    last_y = y;
    out += fmt::format("{:.9g} {:.9g} {:.9g} {:.9g} {}\n", p.x, p.y, p.low,
                       p.high, data_text(is_clear ? p.label : ""));
  }
  return out + "EOD\n";
}

/// Where the axes stand in the figure [pixels from the left, from below].
struct Box {
  double left{}, right{}, below{}, above{};
};
std::string placed(const Box& box, double width, double height) {
  return fmt::format(
      "set lmargin at screen {:.6f}\nset rmargin at screen {:.6f}\n"
      "set bmargin at screen {:.6f}\nset tmargin at screen {:.6f}\n",
      box.left / width, box.right / width, box.below / height,
      box.above / height);
}

std::string drawn_series(const std::string& block, const PlotSeries& series,
                         const Style& style, PlotAxes kind) {
  const bool has_band =
      std::ranges::any_of(series.points, [](const PlotPoint& p) {
        return p.low != p.high;
      });
  std::string out;
  if (has_band) {
    out += fmt::format(
        "  ${} using 1:2:3:4 with yerrorbars pointtype {} pointsize 0.5 "
        "linecolor rgb \"{}\" notitle, \\\n",
        block, style.marker, style.colour);
  } else {
    out += fmt::format(
        "  ${} using 1:2 with {} pointtype {} pointsize 0.8 linewidth 1.5 "
        "linecolor rgb \"{}\" notitle, \\\n",
        block, kind == PlotAxes::kLogarithmic ? "linespoints" : "points",
        style.marker, style.colour);
  }
  const bool has_labels =
      std::ranges::any_of(series.points, [](const PlotPoint& p) {
        return !p.label.empty();
      });
  if (has_labels) {
    out += fmt::format(
        "  ${} using 1:2:5 with labels left offset 0.7,0.5 font \",10\" "
        "textcolor rgb \"{}\" notitle, \\\n",
        block, style.colour);
  }
  return out;
}

std::string drawn_panel(const PlotPanel& panel, std::size_t number,
                        PlotAxes kind, const std::vector<Style>& styles) {
  const Axes axes = axes_of(panel, kind);
  std::string data, plots;
  for (std::size_t s = 0; s < panel.series.size(); ++s) {
    const PlotSeries& series = panel.series[s];
    const std::string block = fmt::format("panel{}_{}", number + 1, s + 1);
    data += data_block(block, series, axes);
    plots += drawn_series(block, series,
                          *std::ranges::find(styles, series.name, &Style::name),
                          kind);
  }
  std::string out = data + fmt::format(
                               "set title {} offset 0,-0.5\nset xlabel {}\n"
                               "set ylabel {} offset 1,0\n"
                               "set xrange [{:.9g}:{:.9g}]\nset yrange "
                               "[{:.9g}:{:.9g}]\n",
                               quoted(panel.title), quoted(panel.x_label),
                               quoted(panel.y_label), axes.x.low, axes.x.high,
                               axes.y.low, axes.y.high);
  if (panel.floor > axes.y.low) {
    out += fmt::format(
        "set object 1 rectangle from graph 0, graph 0 to graph 1, first "
        "{:.9g} behind fillcolor rgb \"#eeeeee\" fillstyle solid noborder\n"
        "set label 1 \"within the uncertainty of the reference\" at graph "
        "0.98, graph 0.03 right font \",10\" textcolor rgb \"#777777\"\n",
        std::min(panel.floor, axes.y.high));
  }
  if (panel.limit) {
    out += fmt::format(
        "set arrow 1 from graph 0, first {0:.9g} to graph 1, first {0:.9g} "
        "nohead dashtype 2 linecolor rgb \"#000000\"\n",
        *panel.limit);
  }
  return out + "plot \\\n" + plots +
         "  NaN notitle\nunset object 1\nunset label 1\nunset arrow 1\n\n";
}

/// Keys and remarks below the panels, as a plot without axes.
std::string drawn_legend(const std::vector<Style>& styles, PlotAxes kind,
                         const std::vector<std::string>& remarks, int keys) {
  std::string out =
      "unset title\nunset xlabel\nunset ylabel\nunset logscale\n"
      "unset tics\nunset border\nunset grid\nset xrange [0:1]\nset yrange "
      "[0:1]\n";
  for (std::size_t k = 0; k < remarks.size(); ++k) {
    out += fmt::format("set label {} {} at graph 0, graph 0 offset 0,{}\n",
                       k + 1, quoted(remarks[k]), remarks.size() - 1 - k);
  }
  out += fmt::format(
      "set key top left Left reverse horizontal maxcols {} samplen 2\nplot "
      "\\\n",
      keys);
  for (const Style& style : styles) {
    out += fmt::format(
        "  NaN with {} pointtype {} pointsize 0.8 linewidth 1.5 linecolor "
        "rgb \"{}\" title {}, \\\n",
        kind == PlotAxes::kLogarithmic ? "linespoints" : "points", style.marker,
        style.colour, quoted(style.name));
  }
  return out + "  NaN notitle\n";
}

}  // namespace

std::string gnuplot_script(const PlotFigure& figure, const std::string& name) {
  constexpr double kCharacter = 7.0, kKey = 60.0;
  const auto panels = shown_panels(figure);
  const auto styles = styles_of(panels);
  const int count = static_cast<int>(panels.size());
  const int across = std::clamp(count, 1, std::max(1, figure.columns));
  const int down = std::max(1, (count + across - 1) / across);
  const double width = across * kPanelWidth;
  std::size_t longest = 1;
  for (const Style& style : styles) {
    longest = std::max(longest, style.name.size());
  }
  const int keys = std::max(
      1, static_cast<int>((width - kLeft - kRight) /
                          (kKey + kCharacter * static_cast<double>(longest))));
  const int lines = (static_cast<int>(styles.size()) + keys - 1) / keys +
                    static_cast<int>(figure.remarks.size());
  const double legend = kLegendLine * (lines + 1);
  const double height = kTitleHeight + down * kPanelHeight + legend;

  std::string out = fmt::format(
      "# gnuplot {0}.gp draws {0}.svg\n"
      "set encoding utf8\n"
      "set terminal svg noenhanced size {1:.0f},{2:.0f} font "
      "\"sans-serif,12\" background \"#ffffff\"\n"
      "set output \"{0}.svg\"\n"
      "set multiplot\n"
      "set label 9 {3} at screen {4:.6f}, screen {5:.6f} font "
      "\",15\"\n"
      "set grid linecolor rgb \"#dddddd\" linetype 1\n"
      "set tics nomirror format \"%g\"\nunset key\n{6}\n",
      name, width, height, quoted(figure.title), kLeft / width,
      1.0 - 18.0 / height,
      figure.axes == PlotAxes::kLogarithmic ? "set logscale xy\n" : "");
  for (int p = 0; p < count; ++p) {
    const double left = p % across * kPanelWidth;
    const double top = height - kTitleHeight - p / across * kPanelHeight;
    out += placed({left + kLeft, left + kPanelWidth - kRight,
                   top - kPanelHeight + kBottom, top - kTop},
                  width, height) +
           drawn_panel(panels[static_cast<std::size_t>(p)],
                       static_cast<std::size_t>(p), figure.axes, styles) +
           (p == 0 ? "unset label 9\n" : "");
  }
  out += placed({kLeft, width - kRight, 0.5 * kLegendLine,
                 legend - 0.25 * kLegendLine},
                width, height) +
         drawn_legend(styles, figure.axes,
                      count > 0 ? figure.remarks
                                : std::vector<std::string>{"nothing to draw"},
                      keys);
  return out + "unset multiplot\nset output\n";
}

}  // namespace clevis::report
