#include "report/picture/picture.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "base/bytes/base64.h"
#include "report/picture/raster.h"
#include "report/picture/svg_parts.h"

namespace clevis::report {
namespace {

// Pixels.
constexpr double kWidth = 1000, kDrawn = 860, kTop = 62, kHighest = 620;
constexpr double kLeast = 190;  // height that the legend needs
constexpr double kBottom = 46, kLegendLeft = 878, kLegendWidth = 16;

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
      out += svg_line({kLegendLeft + kLegendWidth, y(k * step)},
                      {kLegendLeft + kLegendWidth + 4.0, y(k * step)}) +
             svg_text({kLegendLeft + kLegendWidth + 24.0, y(k * step) + 4.0},
                      "", fmt::format("{:.6g}", k * step));
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
  return out + svg_text({kWidth - 8.0, kTop - 2.0}, "text-anchor=\"end\"",
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
         svg_text({x, y},
                  is_left ? "font-weight=\"bold\" paint-order=\"stroke\" "
                            "stroke=\"#fff\" stroke-width=\"4\""
                          : "font-weight=\"bold\" paint-order=\"stroke\" "
                            "stroke=\"#fff\" stroke-width=\"4\" "
                            "text-anchor=\"end\"",
                  fmt::format("{:.4g} MPa{}", mark.value,
                              is_seen ? "" : " (hidden)"));
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
      kWidth, bottom + kBottom, svg_content(picture.title), top, kDrawn,
      std::ceil(needed), base64(std::as_bytes(std::span(png))));
  out += svg_text({16, 26}, "font-size=\"18\" font-weight=\"bold\"",
                  picture.title) +
         svg_text({16, 47}, "", picture.detail) +
         legend(largest, picture.mark, height) +
         svg_axes(placement, bottom + 26.0);
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
