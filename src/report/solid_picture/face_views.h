#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "report/picture/raster.h"

namespace clevis::report {

/// A face of a solid as triangles.
struct DrawnFace {
  int number{};
  std::string group;        ///< empty: none
  Eigen::MatrixX3d points;  ///< [mm]
  std::vector<std::array<int, 3>> triangles;
};

/// A face's number in a view [pixel].
struct FaceNumber {
  int number{};
  Eigen::Vector2d at;   ///< middle of the number
  Eigen::Vector2d dot;  ///< on the face; elsewhere: a line leads to it
};

/// The solid from one side.
struct FaceView {
  Placement placement;
  int width{}, height{};  ///< [pixel]
  std::vector<std::uint8_t> rgb;
  std::vector<FaceNumber> numbers;
};

struct FaceViews {
  std::vector<FaceView> views;
  std::vector<int> hidden;  ///< numbers of faces that none of them shows
};

/// Two opposite views askew, and further ones as long as they show faces that
/// those before do not. A face bears its number wherever it has room for it,
/// or else, at the end of a line, in the view that shows most of it. Faces of
/// groups are coloured.
/// @param width  of a view [pixel].
FaceViews face_views(const std::vector<DrawnFace>& faces, int width);

}  // namespace clevis::report
