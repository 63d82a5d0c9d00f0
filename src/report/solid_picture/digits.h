#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace clevis::report {

/// A picture of three bytes a pixel, row by row from the top.
struct Canvas {
  int width{}, height{};  ///< [pixel]
  std::vector<std::uint8_t> rgb;

  /// White.
  Canvas(int width, int height);
  /// Black or white; nothing outside of the picture.
  void set(int x, int y, std::uint8_t grey);
  /// Copies a picture onto this one. @pre It fits.
  void paste(const std::vector<std::uint8_t>& other, int other_width,
             int other_height, int left, int top);
  /// A black line with a white rim [pixel].
  void line(const Eigen::Vector2d& from, const Eigen::Vector2d& to);
  /// Digits and the letters x, y, z in black with a white rim; others are
  /// blanks.
  /// @param middle  of the text [pixel].
  void write(std::string_view text, const Eigen::Vector2d& middle);
};

/// Half the width and height that `write` takes for so many signs [pixel].
Eigen::Vector2d half_size(std::size_t signs);

}  // namespace clevis::report
