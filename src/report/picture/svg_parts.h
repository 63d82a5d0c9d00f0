#pragma once

#include <string>

#include <Eigen/Core>

#include "report/picture/raster.h"

namespace clevis::report {

/// Text as the content of an element: control characters are blanks, signs of
/// markup escaped.
std::string svg_content(const std::string& text);

/// A line of text.
/// @param at  where it begins [pixel].
/// @param attributes  of the element.
std::string svg_text(const Eigen::Vector2d& at, const char* attributes,
                     const std::string& content);

/// A black line [pixel].
std::string svg_line(const Eigen::Vector2d& from, const Eigen::Vector2d& to);

/// 1, 2 or 5 times a power of ten, at most `value`.
double round_below(double value);

/// The directions of the axes, and how long some round length is.
/// @param bottom  of the drawing [pixel].
std::string svg_axes(const Placement& placement, double bottom);

}  // namespace clevis::report
