#include "report/picture/stored_surface.h"

#include "base/messages/errors.h"
#include "report/stored/stored_numbers.h"

namespace clevis::report {

Surface stored_surface(const JsonNode& view, std::size_t frame) {
  Surface surface;
  const auto places = stored_points(view);
  const auto corners = stored_numbers(view.at("triangles"));
  const auto stress = stored_field(view.at("von_mises_MPa"));
  const auto points = static_cast<Eigen::Index>(places.size() / 3);
  surface.points =
      Eigen::Map<const Eigen::Matrix3Xd>(places.data(), 3, points).transpose();
  const auto column = static_cast<Eigen::Index>(frame);
  if (stress.size() == 0) {
    surface.stress.setZero(points);
  } else if (stress.rows() == points && column < stress.cols()) {
    surface.stress = stress.col(column);
  } else {
    throw Error("I003", "view of a part", "its stress does not fit its points",
                "Run `clevis check` again.");
  }
  for (std::size_t c = 0; c + 2 < corners.size(); c += 3) {
    std::array<int, 3> triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      if (!(corners[c + k] < static_cast<double>(points))) {
        throw Error("I003", "view of a part", "a triangle has no such point",
                    "Run `clevis check` again.");
      }
      triangle[k] = static_cast<int>(corners[c + k]);
    }
    surface.triangles.push_back(triangle);
  }
  double counted = 0.0;
  bool is_count = true;
  for (const double count : stored_numbers(view.at("cell_triangles"))) {
    is_count = is_count && count >= 0.0 && count < 1e6;
    if (!is_count) break;
    surface.cell_triangles.push_back(static_cast<int>(count));
    counted += count;
  }
  if (!is_count || counted != static_cast<double>(surface.triangles.size())) {
    throw Error("I003", "view of a part",
                "its cells have other triangles than the part",
                "Run `clevis check` again.");
  }
  return surface;
}

}  // namespace clevis::report
