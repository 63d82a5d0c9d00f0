#include "app/solids/face_picture.h"

#include <vector>

#include <fmt/format.h>

#include "base/messages/errors.h"
#include "report/solid_picture/face_picture.h"
#include "report/text/atomic_file.h"

namespace clevis::app {
namespace {

constexpr int kViewWidth = 620;  // [pixel]

std::vector<report::DrawnFace> drawn(
    const cad::Solid& solid, const std::function<std::string(int)>& group_of) {
  std::vector<report::DrawnFace> faces;
  for (std::size_t f = 0; f < solid.facets.size(); ++f) {
    const cad::Facets& facets = solid.facets[f];
    const int number = solid.faces.at(f).number;
    report::DrawnFace& face = faces.emplace_back();
    face.number = number;
    face.group = group_of(number);
    face.points.resize(static_cast<Eigen::Index>(facets.points.size()), 3);
    for (std::size_t p = 0; p < facets.points.size(); ++p) {
      face.points.row(static_cast<Eigen::Index>(p)) =
          1e3 * facets.points[p].transpose();  // [mm]
    }
    face.triangles = facets.triangles;
  }
  return faces;
}

}  // namespace

void require_picture_name(const std::filesystem::path& file) {
  if (file.extension() == ".svg" || file.extension() == ".png") return;
  throw Error(
      "U001", "--picture",
      fmt::format("\"{}\" ends neither in .svg nor in .png", file.string()),
      fmt::format(
          "Name it {}.",
          std::filesystem::path(file).replace_extension(".svg").string()));
}

std::vector<int> write_face_picture(
    const cad::Solid& solid, const std::function<std::string(int)>& group_of,
    const std::string& title, const std::filesystem::path& file) {
  const auto faces = drawn(solid, group_of);
  const auto views = report::face_views(faces, kViewWidth);
  report::write_file(file, file.extension() == ".png"
                               ? report::face_picture_png(views)
                               : report::face_picture_svg(views, faces, title));
  return views.hidden;
}

}  // namespace clevis::app
