#pragma once

#include <string>
#include <vector>

#include "report/solid_picture/face_views.h"

namespace clevis::report {

/// The views of a solid as one picture in SVG, two in a row, with the numbers
/// of its faces, axes, scale and what colours mean. Needs no other file.
/// @pre There is a view.
std::string face_picture_svg(const FaceViews& views,
                             const std::vector<DrawnFace>& faces,
                             const std::string& title);

/// The same as PNG, without words.
/// @throws Error X001.
std::string face_picture_png(const FaceViews& views);

}  // namespace clevis::report
