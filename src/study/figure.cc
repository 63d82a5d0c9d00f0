#include "study/figure.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace clevis::study {
namespace {

using report::PlotFigure;
using report::PlotPanel;
using report::PlotSeries;

constexpr double kPercent = 100.0;

/// "3" of "p = 3", "1 %" of "1 %: plane stress, p = 4".
std::string short_label(const std::string& setting) {
  std::string label = setting.substr(0, setting.find(':'));
  if (label.starts_with("p = ")) label.erase(1, 3);
  return label;
}

using Value = std::function<double(const Run&)>;

std::vector<PlotSeries> series_of(const PartStudy& part, const Value& x,
                                  const Value& y) {
  std::vector<PlotSeries> all;
  for (const Run& run : part.runs) {
    if (!run.left_out.empty()) continue;
    auto series = std::ranges::find(all, run.series, &PlotSeries::name);
    if (series == all.end()) {
      all.push_back({run.series, {}});
      series = all.end() - 1;
    }
    const double error = y(run);
    series->points.push_back(
        {x(run), error, error, error, short_label(run.setting)});
  }
  return all;
}

double percent_of(const Reference& reference) {
  return reference.value != 0.0
             ? kPercent * reference.uncertainty / std::abs(reference.value)
             : 0.0;
}

struct Cost {
  const char* label;
  Value of;
};

std::vector<Cost> costs() {
  constexpr double kMegabyte = 1e6;
  return {{"processor seconds",
           [](const Run& r) {
             return r.cpu_seconds;
           }},
          {"degrees of freedom",
           [](const Run& r) {
             return static_cast<double>(r.dofs);
           }},
          {"peak memory, MB", [](const Run& r) {
             return r.memory / kMegabyte;
           }}};
}

PlotPanel peak_panel(const PartStudy& part, const Cost& cost) {
  return {"peak von Mises stress", cost.label, "error, %",
          series_of(part, cost.of,
                    [&part](const Run& r) {
                      return kPercent * relative_error(r.peak, part.peak);
                    }),
          percent_of(part.peak)};
}

PlotPanel energy_panel(const PartStudy& part, const Cost& cost) {
  return {"strain energy", cost.label, "error, %",
          series_of(part, cost.of,
                    [&part](const Run& r) {
                      return kPercent * relative_error(r.energy, part.energy);
                    }),
          percent_of(part.energy)};
}

PlotPanel probe_panel(const PartStudy& part, std::size_t probe,
                      const Cost& cost) {
  return {"probe " + part.probe_names[probe], cost.label, "error, %",
          series_of(part, cost.of,
                    [&part, probe](const Run& r) {
                      return probe < r.probes.size()
                                 ? kPercent * relative_error(r.probes[probe],
                                                             part.probes[probe])
                                 : 0.0;
                    }),
          percent_of(part.probes[probe])};
}

PlotFigure figure_of(const PartStudy& part, std::vector<PlotPanel> panels,
                     int columns) {
  return {fmt::format("{}, {}", part.name, part.load),
          {},
          report::PlotAxes::kLogarithmic,
          columns,
          std::move(panels)};
}

}  // namespace

PlotFigure study_figure(const PartStudy& part) {
  std::vector<PlotPanel> panels;
  const auto all = costs();
  for (const auto& cost : all) panels.push_back(peak_panel(part, cost));
  for (const auto& cost : all) panels.push_back(energy_panel(part, cost));
  for (std::size_t p = 0; p < part.probes.size(); ++p) {
    for (const auto& cost : all) panels.push_back(probe_panel(part, p, cost));
  }
  return figure_of(part, std::move(panels), static_cast<int>(all.size()));
}

PlotFigure peak_against_seconds(const PartStudy& part) {
  PlotPanel panel = peak_panel(part, costs().front());
  // One of the series with Legendre terms is enough to look at.
  std::erase_if(panel.series, [](const PlotSeries& series) {
    return series.name.ends_with("2+2 terms") ||
           series.name.ends_with("4+4 terms");
  });
  return figure_of(part, {std::move(panel)}, 1);
}

}  // namespace clevis::study
