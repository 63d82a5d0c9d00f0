#pragma once

#include <string>
#include <vector>

namespace clevis::study {

/// A point of a plot; both coordinates > 0 for logarithmic axes.
struct PlotPoint {
  double x{}, y{};
  std::string label;  ///< beside the point; may be empty
};

/// Points that belong together, in the order in which they are joined.
struct PlotSeries {
  std::string name;
  std::vector<PlotPoint> points;
};

/// One pair of logarithmic axes.
struct Panel {
  std::string title, x_label, y_label;
  std::vector<PlotSeries> series;
  /// Errors below it say nothing: the reference itself is no better. 0: none.
  double floor{};
};

/// A figure in SVG: the panels side by side, `columns` in a row, with one
/// legend for all: a name has one colour and marker everywhere. Points that
/// are not > 0 and finite are left out; so are panels without any.
std::string svg_figure(const std::string& title,
                       const std::vector<Panel>& panels, int columns);

}  // namespace clevis::study
