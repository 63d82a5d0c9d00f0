#include "report/picture/svg_parts.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "report/text/markup.h"

namespace clevis::report {

std::string svg_content(const std::string& text) {
  std::string plain = text;
  std::ranges::replace_if(
      plain,
      [](char c) {
        return static_cast<unsigned char>(c) < 0x20;
      },
      ' ');
  return escape_markup(plain);
}

std::string svg_text(const Eigen::Vector2d& at, const char* attributes,
                     const std::string& content) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", at.x(),
                     at.y(), attributes, svg_content(content));
}

std::string svg_line(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  return fmt::format(
      "<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"#000\"/>\n", from.x(),
      from.y(), to.x(), to.y());
}

/// 1, 2 or 5 times a power of ten, at most `value`.
double round_below(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  const double share = value / decade;
  return decade * (share >= 5.0 ? 5.0 : share >= 2.0 ? 2.0 : 1.0);
}

/// The directions of the axes, and how long some round length is.
std::string svg_axes(const Placement& placement, double bottom) {
  constexpr double kLength = 18.0, kLongest = 160.0;
  const Eigen::Vector2d origin(34.0, bottom - 4.0);
  std::string out;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d seen = placement.sight.col(axis);
    const Eigen::Vector2d arm(seen.x(), -seen.y());
    if (arm.norm() < 0.2) continue;
    out += svg_line(origin, origin + kLength * arm) +
           svg_text(origin + (kLength + 8.0) * arm + Eigen::Vector2d(-3.0, 4.0),
                    "", std::string(1, "xyz"[axis]));
  }
  const double millimetres = round_below(kLongest / placement.scale);
  const Eigen::Vector2d from(90.0, bottom + 4.0);
  const Eigen::Vector2d to =
      from + Eigen::Vector2d(millimetres * placement.scale, 0.0);
  for (const auto& end : {from, to}) {
    out += svg_line(end - Eigen::Vector2d(0, 4), end + Eigen::Vector2d(0, 4));
  }
  return out + svg_line(from, to) +
         svg_text(to + Eigen::Vector2d(8.0, 4.0), "",
                  fmt::format("{:g} mm", millimetres));
}

}  // namespace clevis::report
