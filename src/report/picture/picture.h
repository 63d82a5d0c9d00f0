#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "report/picture/surface.h"

namespace clevis::report {

/// The worst place of a part.
struct PeakMark {
  Eigen::Vector3d at;             ///< [mm]
  double value{}, low{}, high{};  ///< peak and its band [MPa]
  bool has_band{};
};

/// What a picture shows.
struct Picture {
  std::string title, detail;  ///< lines above it
  /// Surfaces; those of a layer stand before those of layers ahead of it.
  std::vector<std::vector<Surface>> layers;
  Sight sight = Sight::Identity();
  std::optional<PeakMark> mark;
};

/// The picture as SVG: surfaces as an image in it, title, legend with unit and
/// band, mark, axes and scale as text and lines. Needs no other file.
/// @pre There is a surface.
std::string svg_of(const Picture& picture);

}  // namespace clevis::report
