#pragma once

#include <string>
#include <vector>

namespace clevis::report::svg {

/// The text as content of an element; control characters become blanks.
std::string escaped(const std::string& text);

/// A text that starts at (x, y) [pixels].
std::string text(double x, double y, const char* attributes,
                 const std::string& content);

/// A line between two points [pixels].
std::string line(double x1, double y1, double x2, double y2,
                 const char* colour);

/// A figure on white with its title [pixels].
std::string page(double width, double height, const std::string& title,
                 const std::string& content);

/// A linear axis onto pixels.
struct Axis {
  double low{}, high{};   ///< ends, in the units of the values
  double begin{}, end{};  ///< pixels
  double at(double value) const {
    return begin + (value - low) / (high - low) * (end - begin);
  }
};

/// Ends of the axis a little beyond the least and the largest value.
Axis fitted_axis(double least, double largest, double begin, double end);

/// Some five round numbers within the axis.
std::vector<double> ticks(const Axis& axis);

}  // namespace clevis::report::svg
