#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "cad/face.h"

namespace clevis::app {

/// @throws Error U001 if a file ends neither in .svg nor in .png.
void require_picture_name(const std::filesystem::path& file);

/// Draws a solid with its faces' numbers.
/// @param solid  with facets.
/// @param group_of  name of a face's group by its number; empty: none.
/// @param file  .svg or .png.
/// @return numbers of the faces that no view shows.
/// @throws Error I002, X001.
std::vector<int> write_face_picture(
    const cad::Solid& solid, const std::function<std::string(int)>& group_of,
    const std::string& title, const std::filesystem::path& file);

}  // namespace clevis::app
