#include "report/figures/plot.h"

#include <limits>
#include <regex>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

namespace clevis::report {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos;
       at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

PlotFigure figure(std::vector<PlotPoint> points) {
  return {"t",
          {},
          PlotAxes::kLogarithmic,
          1,
          {{"error", "seconds", "error, %", {{"clevis", std::move(points)}}}}};
}

/// Lines of the first block of data.
std::size_t data_lines(const std::string& script) {
  const auto begin = script.find("<< EOD\n") + 7;
  return count(script.substr(begin, script.find("EOD\n", begin) - begin), "\n");
}

TEST(Plot, PointsThatHaveNoLogarithmAreLeftOut) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto script =
      gnuplot_script(figure({{1, 1}, {0, 1}, {1, 0}, {1, nan}, {1, 2}}), "x");
  EXPECT_EQ(data_lines(script), 2u);
  EXPECT_EQ(script.find("nan"), std::string::npos);
  EXPECT_EQ(script.find("inf"), std::string::npos);
}

TEST(Plot, LinearAxesShowZeroAndLess) {
  PlotFigure linear = figure({{-1, 0}, {0, 1}});
  linear.axes = PlotAxes::kLinear;
  EXPECT_EQ(data_lines(gnuplot_script(linear, "x")), 2u);
  EXPECT_EQ(gnuplot_script(linear, "x").find("logscale xy"), std::string::npos);
}

TEST(Plot, NothingToDrawIsSaid) {
  const auto script = gnuplot_script(figure({{0, 0}}), "x");
  EXPECT_EQ(script.find("EOD"), std::string::npos);
  EXPECT_NE(script.find("\"nothing to draw\""), std::string::npos);
}

TEST(Plot, NoCharacterOfATextMeansAnythingToGnuplot) {
  const std::string hostile =
      "\"; system('touch owned') #`touch owned`@x\\101$y{/Symbol a}\nplot\n"
      "EOD\n!touch owned\n";
  PlotFigure plot = figure({{1, 1, 1, 1, hostile}, {10, 0.1, 0.1, 0.1, "3"}});
  plot.title = hostile;
  plot.remarks = {hostile};
  PlotPanel& panel = plot.panels[0];
  panel.title = panel.x_label = panel.y_label = hostile;
  panel.series[0].name = hostile;
  const auto script = gnuplot_script(plot, "x");
  for (const char mark : {'`', '@', '!', '{', '\'', '|', '*'}) {
    EXPECT_EQ(script.find(mark), std::string::npos) << mark;
  }
  // Every string ends on its line, every line is one that is known.
  std::istringstream lines(script);
  bool in_data = false;
  const std::regex known(
      "^(# gnuplot |set |unset |plot |  \\$panel|  NaN|\\$panel\\d+_\\d+ << "
      "EOD|$).*");
  for (std::string line; std::getline(lines, line);) {
    if (line == "EOD") {
      in_data = false;
    } else if (!in_data) {
      EXPECT_TRUE(std::regex_match(line, known)) << line;
    }
    EXPECT_EQ(count(line, "\"") % 2, 0u) << line;
    if (line.ends_with("<< EOD")) in_data = true;
  }
  EXPECT_EQ(count(script, "\nEOD\n"), 1u);
  EXPECT_NE(script.find("noenhanced"), std::string::npos);
}

TEST(Plot, TextsThatArePlainStayReadable) {
  PlotFigure plot = figure({{1, 1}});
  plot.title = "link, t = 0.5 s (3-D)";
  EXPECT_NE(gnuplot_script(plot, "x").find("\"link, t = 0.5 s (3-D)\""),
            std::string::npos);
  plot.title = "Länge";
  EXPECT_NE(gnuplot_script(plot, "x").find("\"L\\0303\\0244nge\""),
            std::string::npos);
}

TEST(Plot, ANameHasOneColourInAllPanelsAndOneKeyInTheLegend) {
  PlotFigure plot = figure({{1, 1}});
  plot.panels.push_back(plot.panels[0]);
  auto& second = plot.panels[1].series;
  second.insert(second.begin(), {"other", {{2, 2}}});
  const auto script = gnuplot_script(plot, "x");
  EXPECT_EQ(count(script, "title \"clevis\""), 1u);
  EXPECT_EQ(count(script, "title \"other\""), 1u);
  EXPECT_EQ(count(script, "#0072b2"), 3u);  // twice and its key
  EXPECT_EQ(count(script, "#d55e00"), 2u);
}

TEST(Plot, NoTwoOfManySeriesLookAlike) {
  PlotFigure plot = figure({{1, 1}});
  auto& series = plot.panels[0].series;
  for (int k = 1; k < 30; ++k) {
    series.push_back({std::to_string(k), {{1, 1}}});
  }
  const auto script = gnuplot_script(plot, "x");
  const std::regex look("  NaN with .* pointtype (\\d+) .* rgb (\\S+) title");
  std::set<std::string> looks;
  for (auto at = std::sregex_iterator(script.begin(), script.end(), look);
       at != std::sregex_iterator(); ++at) {
    looks.insert((*at)[1].str() + (*at)[2].str());
  }
  EXPECT_EQ(looks.size(), 30u);
}

TEST(Plot, FloorIsGreyOnlyWhereItShows) {
  PlotFigure plot = figure({{1, 1}, {10, 0.1}});
  plot.panels[0].floor = 0.2;
  EXPECT_NE(gnuplot_script(plot, "x").find("uncertainty"), std::string::npos);
  plot.panels[0].floor = 1e-9;
  EXPECT_EQ(gnuplot_script(plot, "x").find("uncertainty"), std::string::npos);
}

TEST(Plot, BandsAndLimitAreDrawn) {
  PlotFigure plot = figure({{1, 5, 4, 6}});
  plot.axes = PlotAxes::kLinear;
  plot.panels[0].limit = 9.0;
  const auto script = gnuplot_script(plot, "x");
  EXPECT_NE(script.find("yerrorbars"), std::string::npos);
  EXPECT_NE(script.find("first 9 to graph 1"), std::string::npos);
}

}  // namespace
}  // namespace clevis::report
