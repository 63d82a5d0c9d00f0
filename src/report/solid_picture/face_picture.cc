#include "report/solid_picture/face_picture.h"

#include <algorithm>
#include <map>
#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/bytes/base64.h"
#include "report/picture/png.h"
#include "report/picture/svg_parts.h"
#include "report/solid_picture/digits.h"

namespace clevis::report {
namespace {

using Eigen::Vector2d;

constexpr int kFoot = 46;  // under each view, for axes [pixel]

/// Where views stand: two in a row.
struct Sheet {
  std::vector<Eigen::Vector2i> corners;  ///< of each view [pixel]
  int width{}, height{};                 ///< [pixel]
};

Sheet sheet_of(const FaceViews& views, int top) {
  Sheet sheet;
  sheet.height = top;
  for (std::size_t v = 0; v < views.views.size(); v += 2) {
    int left = 0, tallest = 0;
    for (std::size_t k = v; k < std::min(v + 2, views.views.size()); ++k) {
      sheet.corners.emplace_back(left, sheet.height);
      left += views.views[k].width;
      tallest = std::max(tallest, views.views[k].height);
    }
    sheet.width = std::max(sheet.width, left);
    sheet.height += tallest + kFoot;
  }
  return sheet;
}

bool has_line(const FaceNumber& number) {
  return (number.at - number.dot).norm() > 1.0;
}

/// Where the line to a number ends: before its signs.
Vector2d end_of(const FaceNumber& number) {
  constexpr double kRim = 2.0;
  const Vector2d half =
      half_size(std::to_string(number.number).size()) + Vector2d(kRim, kRim);
  const Vector2d way = number.dot - number.at;
  const double share =
      std::min({1.0, half.x() / std::max(1e-9, std::abs(way.x())),
                half.y() / std::max(1e-9, std::abs(way.y()))});
  return number.at + share * way;
}

std::string svg_number(const FaceNumber& number) {
  constexpr double kBaseline = 5.0;
  std::string out;
  if (has_line(number)) {
    const Vector2d end = end_of(number);
    out = fmt::format(
        "<path d=\"M{0:.1f} {1:.1f}L{2:.1f} {3:.1f}\" stroke=\"#fff\" "
        "stroke-width=\"3\"/>\n"
        "<path d=\"M{0:.1f} {1:.1f}L{2:.1f} {3:.1f}\" stroke=\"#000\"/>\n"
        "<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"2\"/>\n",
        number.dot.x(), number.dot.y(), end.x(), end.y());
  }
  return out + svg_text(number.at + Vector2d(0.0, kBaseline),
                        "class=\"face\" font-size=\"15\" font-weight=\"bold\" "
                        "text-anchor=\"middle\" paint-order=\"stroke\" "
                        "stroke=\"#fff\" stroke-width=\"3\"",
                        std::to_string(number.number));
}

/// "bore_A: 3 4; tip: 7; no view shows 9".
std::string detail_of(const FaceViews& views,
                      const std::vector<DrawnFace>& faces) {
  std::map<std::string, std::vector<int>> groups;
  for (const DrawnFace& face : faces) {
    if (!face.group.empty()) groups[face.group].push_back(face.number);
  }
  std::string text;
  for (const auto& [group, numbers] : groups) {
    text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", group,
                        fmt::join(numbers, " "));
  }
  if (!views.hidden.empty()) {
    text += fmt::format("{}no view shows {}", text.empty() ? "" : "; ",
                        fmt::join(views.hidden, " "));
  }
  return text;
}

}  // namespace

std::string face_picture_svg(const FaceViews& views,
                             const std::vector<DrawnFace>& faces,
                             const std::string& title) {
  constexpr int kTop = 58;
  const Sheet sheet = sheet_of(views, kTop);
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" "
      "xmlns:xlink=\"http://www.w3.org/1999/xlink\" width=\"{0}\" "
      "height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "font-family=\"sans-serif\" font-size=\"13\">\n"
      "<title>{2}</title>\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n",
      sheet.width, sheet.height, svg_content(title));
  out += svg_text({16, 26}, "font-size=\"18\" font-weight=\"bold\"", title) +
         svg_text({16, 47}, "", detail_of(views, faces));
  for (std::size_t v = 0; v < views.views.size(); ++v) {
    const FaceView& view = views.views[v];
    const std::string png = png_of(view.rgb, view.width, view.height);
    out += fmt::format(
        "<g transform=\"translate({} {})\">\n<image width=\"{}\" "
        "height=\"{}\" xlink:href=\"data:image/png;base64,{}\"/>\n",
        sheet.corners[v].x(), sheet.corners[v].y(), view.width, view.height,
        base64(std::as_bytes(std::span(png))));
    for (const FaceNumber& number : view.numbers) out += svg_number(number);
    out += svg_axes(view.placement, view.height + 16.0) + "</g>\n";
  }
  return out + "</svg>\n";
}

std::string face_picture_png(const FaceViews& views) {
  const Sheet sheet = sheet_of(views, 0);
  Canvas canvas(sheet.width, sheet.height);
  for (std::size_t v = 0; v < views.views.size(); ++v) {
    const FaceView& view = views.views[v];
    const Vector2d corner = sheet.corners[v].cast<double>();
    canvas.paste(view.rgb, view.width, view.height, sheet.corners[v].x(),
                 sheet.corners[v].y());
    for (const FaceNumber& number : view.numbers) {
      if (has_line(number)) {
        canvas.line(corner + number.dot, corner + end_of(number));
      }
    }
    for (const FaceNumber& number : view.numbers) {
      canvas.write(std::to_string(number.number), corner + number.at);
    }
    constexpr double kArm = 18.0;
    const Vector2d origin = corner + Vector2d(34.0, view.height + 8.0);
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d seen = view.placement.sight.col(axis);
      const Vector2d arm(seen.x(), -seen.y());
      if (arm.norm() < 0.2) continue;
      canvas.line(origin, origin + kArm * arm);
      canvas.write(std::string(1, "xyz"[axis]), origin + (kArm + 9.0) * arm);
    }
  }
  return png_of(canvas.rgb, canvas.width, canvas.height);
}

}  // namespace clevis::report
