#pragma once

#include <optional>
#include <string>
#include <vector>

namespace clevis::report {

/// A point of a plot, with a band where `low` and `high` differ.
struct PlotPoint {
  double x{}, y{};
  double low = y, high = y;
  std::string label = {};  ///< beside the point
};

/// Points that belong together.
struct PlotSeries {
  std::string name;
  std::vector<PlotPoint> points;
  std::string colour = {};  ///< "#RRGGBB"; empty: by its place in the legend
};

/// One pair of axes.
struct PlotPanel {
  std::string title, x_label, y_label;
  std::vector<PlotSeries> series;
  /// Errors below it say nothing: the reference itself is no better. 0: none.
  double floor = 0.0;
  std::optional<double> limit = {};  ///< drawn as a dashed line
};

/// Logarithmic axes join their points by lines.
enum class PlotAxes { kLinear, kLogarithmic };

/// Panels side by side, with one legend for all: a name has one colour and
/// marker everywhere.
struct PlotFigure {
  std::string title;
  std::vector<std::string> remarks;  ///< below the legend, a line each
  PlotAxes axes = PlotAxes::kLinear;
  int columns = 1;  ///< of panels in a row, at most
  std::vector<PlotPanel> panels = {};
};

/// A figure as a script of gnuplot 5 with its data, which draws NAME.svg into
/// the working folder. Points that are not finite, on logarithmic axes not > 0,
/// are left out; so are panels without any. Texts are only ever texts: no
/// character of theirs means anything to gnuplot.
/// @pre is_file_name(name).
std::string gnuplot_script(const PlotFigure& figure, const std::string& name);

}  // namespace clevis::report
