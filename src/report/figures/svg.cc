#include "report/figures/svg.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "report/text/markup.h"

namespace clevis::report::svg {

std::string escaped(const std::string& text) {
  std::string plain = text;
  std::ranges::replace_if(
      plain,
      [](char c) {
        return static_cast<unsigned char>(c) < 0x20;
      },
      ' ');
  return escape_markup(plain);
}

std::string text(double x, double y, const char* attributes,
                 const std::string& content) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", x, y,
                     attributes, escaped(content));
}

std::string line(double x1, double y1, double x2, double y2,
                 const char* colour) {
  return fmt::format(
      "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" "
      "stroke=\"{}\"/>\n",
      x1, y1, x2, y2, colour);
}

std::string page(double width, double height, const std::string& title,
                 const std::string& content) {
  constexpr double kLeft = 66, kBaseline = 22;
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" "
             "height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
             "font-family=\"sans-serif\" font-size=\"12\">\n"
             "<rect width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"#ffffff\"/>\n",
             width, height) +
         text(kLeft, kBaseline, "font-size=\"15\" font-weight=\"bold\"",
              title) +
         content + "</svg>\n";
}

Axis fitted_axis(double least, double largest, double begin, double end) {
  constexpr double kMargin = 0.06;  // of the range
  double margin = kMargin * (largest - least);
  if (!(margin > 0.0)) margin = 0.1 * std::abs(least);
  if (!(margin > 0.0)) margin = 1.0;
  return {least - margin, largest + margin, begin, end};
}

std::vector<double> ticks(const Axis& axis) {
  constexpr double kWanted = 5.0;
  const double raw = (axis.high - axis.low) / kWanted;
  const double decade = std::pow(10.0, std::floor(std::log10(raw)));
  const double share = raw / decade;
  const double step = decade * (share > 5.0   ? 10.0
                                : share > 2.0 ? 5.0
                                : share > 1.0 ? 2.0
                                              : 1.0);
  std::vector<double> values;
  const double first = std::ceil(axis.low / step);
  for (double n = first; n * step <= axis.high; n += 1.0) {
    values.push_back(n * step);
  }
  return values;
}

}  // namespace clevis::report::svg
