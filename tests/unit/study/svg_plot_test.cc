#include "study/svg_plot.h"

#include <cmath>
#include <limits>
#include <regex>

#include <gtest/gtest.h>

namespace clevis::study {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos;
       at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

/// Coordinates of the circles: the first series' markers; the last is the
/// legend's.
std::vector<std::pair<double, double>> circles(const std::string& svg) {
  const std::regex circle("cx=\"([0-9.-]+)\" cy=\"([0-9.-]+)\"");
  std::vector<std::pair<double, double>> found;
  for (auto at = std::sregex_iterator(svg.begin(), svg.end(), circle);
       at != std::sregex_iterator(); ++at) {
    found.emplace_back(std::stod((*at)[1]), std::stod((*at)[2]));
  }
  return found;
}

Panel panel(std::vector<PlotPoint> points) {
  return {"error", "seconds", "error, %", {{"clevis", std::move(points)}}, 0.0};
}

TEST(SvgPlot, AxesAreLogarithmic) {
  const auto at = circles(svg_figure(
      "t", {panel({{0.01, 10, ""}, {0.1, 1, ""}, {10, 0.01, ""}})}, 1));
  ASSERT_EQ(at.size(), 4U);
  EXPECT_NEAR(at[2].first - at[1].first, 2.0 * (at[1].first - at[0].first),
              0.3);
  EXPECT_NEAR(at[2].second - at[1].second, 2.0 * (at[1].second - at[0].second),
              0.3);
  EXPECT_GT(at[1].first, at[0].first);    // to the right
  EXPECT_GT(at[1].second, at[0].second);  // SVG's y points down
}

TEST(SvgPlot, PointsThatHaveNoLogarithmAreLeftOut) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto svg = svg_figure(
      "t", {panel({{1, 1, ""}, {0, 1, ""}, {1, 0, ""}, {1, nan, ""}})}, 1);
  EXPECT_EQ(circles(svg).size(), 2U);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
  const auto empty = svg_figure("nothing", {panel({{0, 0, ""}})}, 3);
  EXPECT_TRUE(empty.ends_with("</svg>\n"));
  EXPECT_EQ(empty.find("inf"), std::string::npos);
}

TEST(SvgPlot, NamesAreEscaped) {
  Panel hostile = panel({{1, 1, "<a&b>"}});
  hostile.title = "p < 1 & q > 2";
  const auto svg = svg_figure("x\ny", {hostile}, 1);
  EXPECT_NE(svg.find("&lt;a&amp;b&gt;"), std::string::npos);
  EXPECT_NE(svg.find("p &lt; 1 &amp; q &gt; 2"), std::string::npos);
  EXPECT_EQ(count(svg, "<svg"), 1U);
  EXPECT_EQ(count(svg, "<text"), count(svg, "</text>"));
}

TEST(SvgPlot, ANameHasOneColourInAllPanelsAndOneKeyInTheLegend) {
  Panel first = panel({{1, 1, ""}});
  Panel second = panel({{1, 1, ""}});
  second.series.insert(second.series.begin(), {"other", {{2, 2, ""}}});
  const auto svg = svg_figure("t", {first, second}, 2);
  EXPECT_EQ(circles(svg).size(), 3U);  // "clevis" twice and its key
  EXPECT_EQ(count(svg, ">clevis</text>"), 1U);
  EXPECT_EQ(count(svg, ">other</text>"), 1U);
}

TEST(SvgPlot, FloorIsGreyOnlyWhereItShows) {
  Panel low = panel({{1, 1, ""}, {10, 0.1, ""}});
  low.floor = 0.2;
  EXPECT_NE(svg_figure("t", {low}, 1).find("uncertainty"), std::string::npos);
  low.floor = 1e-9;
  EXPECT_EQ(svg_figure("t", {low}, 1).find("uncertainty"), std::string::npos);
}

}  // namespace
}  // namespace clevis::study
