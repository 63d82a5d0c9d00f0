#include "report/picture/picture.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "base/base64.h"
#include "report/picture/raster.h"
#include "report/text/markup.h"

namespace clevis::report {
namespace {

// Pixels.
constexpr double kWidth = 1000, kDrawn = 860, kTop = 62, kHighest = 620;
constexpr double kLeast = 190;  // height that the legend needs
constexpr double kBottom = 46, kLegendLeft = 878, kLegendWidth = 16;

std::string shown_text(const std::string& text) {
  std::string plain = text;
  std::ranges::replace_if(
      plain,
      [](char c) {
        return static_cast<unsigned char>(c) < 0x20;
      },
      ' ');
  return escape_markup(plain);
}

std::string text(const Eigen::Vector2d& at, const char* attributes,
                 const std::string& content) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", at.x(),
                     at.y(), attributes, shown_text(content));
}

std::string line(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
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

/// Colours from 0 to the largest stress with numbers, and the band of the peak.
std::string legend(double largest, const std::optional<PeakMark>& mark,
                   double height) {
  const double top = kTop + 14.0, bottom = top + height - 28.0;
  const double high =
      std::max(largest, mark && mark->has_band ? mark->high : 0.0);
  const auto y = [&](double stress) {
    return bottom - (high > 0.0 ? stress / high : 0.0) * (bottom - top);
  };
  std::string out =
      "<defs><linearGradient id=\"stress\" x1=\"0\" y1=\"1\" "
      "x2=\"0\" y2=\"0\">";
  const auto colours = stress_colours();
  for (std::size_t k = 0; k < colours.size(); ++k) {
    out += fmt::format(
        "<stop offset=\"{:.4f}\" stop-color=\"#{}\"/>",
        static_cast<double>(k) / static_cast<double>(colours.size() - 1),
        colours[k]);
  }
  out += fmt::format(
      "</linearGradient></defs>\n<rect x=\"{:.1f}\" y=\"{:.1f}\" "
      "width=\"{:.1f}\" height=\"{:.1f}\" fill=\"url(#stress)\"/>\n",
      kLegendLeft, y(largest), kLegendWidth, bottom - y(largest));
  if (high > 0.0) {
    const double step = round_below(high / 4.0);
    for (int k = 0; k * step <= high * (1.0 + 1e-9); ++k) {
      out += line({kLegendLeft + kLegendWidth, y(k * step)},
                  {kLegendLeft + kLegendWidth + 4.0, y(k * step)}) +
             text({kLegendLeft + kLegendWidth + 24.0, y(k * step) + 4.0}, "",
                  fmt::format("{:.6g}", k * step));
    }
  }
  if (mark && mark->has_band) {
    const double from = y(mark->low), to = y(mark->high);
    out += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"8\" height=\"{:.1f}\" "
        "fill=\"#9ecae1\" stroke=\"#0072b2\"><title>band of the peak</title>"
        "</rect>\n",
        kLegendLeft + kLegendWidth + 7.0, to, std::max(1.0, from - to));
  }
  return out + text({kWidth - 8.0, kTop - 2.0}, "text-anchor=\"end\"",
                    "von Mises, MPa");
}

/// Where the peak stands, and how large it is.
std::string marked(const PeakMark& mark, const Eigen::Vector2d& at,
                   bool is_seen) {
  const bool is_left = at.x() < 0.5 * kDrawn;
  const double x = at.x() + (is_left ? 14.0 : -14.0);
  const double y = std::max(at.y() - 12.0, kTop + 10.0);
  return fmt::format(
             "<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"8\" fill=\"none\" "
             "stroke=\"#fff\" stroke-width=\"5\"/>\n"
             "<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"8\" fill=\"none\" "
             "stroke=\"#000\" stroke-width=\"2\"{2}/>\n",
             at.x(), at.y(), is_seen ? "" : " stroke-dasharray=\"3 3\"") +
         text({x, y},
              is_left ? "font-weight=\"bold\" paint-order=\"stroke\" "
                        "stroke=\"#fff\" stroke-width=\"4\""
                      : "font-weight=\"bold\" paint-order=\"stroke\" "
                        "stroke=\"#fff\" stroke-width=\"4\" "
                        "text-anchor=\"end\"",
              fmt::format("{:.4g} MPa{}", mark.value,
                          is_seen ? "" : " (hidden)"));
}

/// The directions of the axes, and how long some round length is.
std::string axes(const Placement& placement, double bottom) {
  constexpr double kLength = 18.0, kLongest = 160.0;
  const Eigen::Vector2d origin(34.0, bottom - 4.0);
  std::string out;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d seen = placement.sight.col(axis);
    const Eigen::Vector2d arm(seen.x(), -seen.y());
    if (arm.norm() < 0.2) continue;
    out += line(origin, origin + kLength * arm) +
           text(origin + (kLength + 8.0) * arm + Eigen::Vector2d(-3.0, 4.0), "",
                std::string(1, "xyz"[axis]));
  }
  const double millimetres = round_below(kLongest / placement.scale);
  const Eigen::Vector2d from(90.0, bottom + 4.0);
  const Eigen::Vector2d to =
      from + Eigen::Vector2d(millimetres * placement.scale, 0.0);
  for (const auto& end : {from, to}) {
    out += line(end - Eigen::Vector2d(0, 4), end + Eigen::Vector2d(0, 4));
  }
  return out + line(from, to) +
         text(to + Eigen::Vector2d(8.0, 4.0), "",
              fmt::format("{:g} mm", millimetres));
}

Eigen::MatrixX3d all_points(const Picture& picture) {
  Eigen::Index count = 0;
  for (const auto& layer : picture.layers) {
    for (const Surface& surface : layer) count += surface.points.rows();
  }
  Eigen::MatrixX3d points(count, 3);
  Eigen::Index at = 0;
  for (const auto& layer : picture.layers) {
    for (const Surface& surface : layer) {
      points.middleRows(at, surface.points.rows()) = surface.points;
      at += surface.points.rows();
    }
  }
  return points;
}

double largest_stress(const Picture& picture) {
  double largest = 0.0;
  for (const auto& layer : picture.layers) {
    for (const Surface& surface : layer) {
      largest = std::max(largest, surface.stress.maxCoeff());
    }
  }
  return largest;
}

}  // namespace

std::string svg_of(const Picture& picture) {
  const auto [placement, needed] =
      fitted(picture.sight, all_points(picture), kDrawn, kHighest);
  const double largest = largest_stress(picture);
  Raster raster(static_cast<int>(kDrawn), static_cast<int>(std::ceil(needed)));
  for (const auto& layer : picture.layers) {
    raster.begin_layer();
    for (const Surface& surface : layer) {
      raster.draw(surface, placement, largest);
    }
  }
  const std::string png = raster.png();
  const double height = std::max(needed, kLeast);
  const double top = kTop + 0.5 * (height - needed);
  const double bottom = kTop + height;
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" "
      "xmlns:xlink=\"http://www.w3.org/1999/xlink\" width=\"{0:.0f}\" "
      "height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
      "font-family=\"sans-serif\" font-size=\"13\">\n"
      "<title>{2}</title>\n"
      "<rect width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"#fff\"/>\n"
      "<image x=\"0\" y=\"{3:.1f}\" width=\"{4:.0f}\" height=\"{5:.0f}\" "
      "xlink:href=\"data:image/png;base64,{6}\"/>\n",
      kWidth, bottom + kBottom, shown_text(picture.title), top, kDrawn,
      std::ceil(needed), base64(std::as_bytes(std::span(png))));
  out +=
      text({16, 26}, "font-size=\"18\" font-weight=\"bold\"", picture.title) +
      text({16, 47}, "", picture.detail) +
      legend(largest, picture.mark, height) + axes(placement, bottom + 26.0);
  if (picture.mark) {
    const auto& surfaces = picture.layers.back();
    const bool seen = std::ranges::all_of(surfaces, [&](const Surface& s) {
      return is_seen(s, picture.sight, picture.mark->at);
    });
    out +=
        marked(*picture.mark,
               placement.at(picture.mark->at) + Eigen::Vector2d(0, top), seen);
  }
  return out + "</svg>\n";
}

}  // namespace clevis::report
