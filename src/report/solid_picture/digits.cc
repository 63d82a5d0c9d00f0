#include "report/solid_picture/digits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace clevis::report {
namespace {

constexpr int kColumns = 5, kRows = 7;
constexpr int kPixel = 2;            // of the picture per dot of a sign
constexpr int kStep = kColumns + 1;  // from sign to sign

/// Rows from the top, the left dot in the highest of five bits.
using Glyph = std::array<std::uint8_t, kRows>;

constexpr std::array<Glyph, 10> kDigits{{
    {0x0E, 0x11, 0x13, 0x15, 0x19, 0x11, 0x0E},
    {0x04, 0x0C, 0x04, 0x04, 0x04, 0x04, 0x0E},
    {0x0E, 0x11, 0x01, 0x02, 0x04, 0x08, 0x1F},
    {0x1F, 0x02, 0x04, 0x02, 0x01, 0x11, 0x0E},
    {0x02, 0x06, 0x0A, 0x12, 0x1F, 0x02, 0x02},
    {0x1F, 0x10, 0x1E, 0x01, 0x01, 0x11, 0x0E},
    {0x06, 0x08, 0x10, 0x1E, 0x11, 0x11, 0x0E},
    {0x1F, 0x01, 0x02, 0x04, 0x08, 0x08, 0x08},
    {0x0E, 0x11, 0x11, 0x0E, 0x11, 0x11, 0x0E},
    {0x0E, 0x11, 0x11, 0x0F, 0x01, 0x02, 0x0C},
}};
constexpr std::array<Glyph, 3> kLetters{{
    {0x00, 0x00, 0x11, 0x0A, 0x04, 0x0A, 0x11},  // x
    {0x00, 0x00, 0x11, 0x11, 0x0F, 0x01, 0x0E},  // y
    {0x00, 0x00, 0x1F, 0x02, 0x04, 0x08, 0x1F},  // z
}};

std::optional<Glyph> glyph_of(char sign) {
  if ('0' <= sign && sign <= '9') {
    return kDigits[static_cast<std::size_t>(sign - '0')];
  }
  if ('x' <= sign && sign <= 'z') {
    return kLetters[static_cast<std::size_t>(sign - 'x')];
  }
  return std::nullopt;
}

constexpr std::uint8_t kBlack = 0, kWhite = 255;

}  // namespace

Canvas::Canvas(int width_, int height_)
    : width(width_),
      height(height_),
      rgb(3 * static_cast<std::size_t>(width_) *
              static_cast<std::size_t>(height_),
          kWhite) {}

void Canvas::set(int x, int y, std::uint8_t grey) {
  if (x < 0 || y < 0 || x >= width || y >= height) return;
  const std::size_t at =
      3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x));
  std::fill_n(rgb.begin() + static_cast<std::ptrdiff_t>(at), 3, grey);
}

void Canvas::paste(const std::vector<std::uint8_t>& other, int other_width,
                   int other_height, int left, int top) {
  for (int y = 0; y < other_height; ++y) {
    std::copy_n(other.begin() + std::ptrdiff_t{3} * y * other_width,
                std::ptrdiff_t{3} * other_width,
                rgb.begin() + std::ptrdiff_t{3} * ((top + y) * width + left));
  }
}

void Canvas::line(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  const int steps =
      static_cast<int>(std::ceil((to - from).cwiseAbs().maxCoeff())) + 1;
  for (const bool is_rim : {true, false}) {
    for (int k = 0; k <= steps; ++k) {
      const Eigen::Vector2d at = from + (to - from) * k / steps;
      const int x = static_cast<int>(at.x()), y = static_cast<int>(at.y());
      if (!is_rim) {
        set(x, y, kBlack);
        continue;
      }
      for (int d = -1; d <= 1; ++d) {
        set(x + d, y, kWhite);
        set(x, y + d, kWhite);
      }
    }
  }
}

void Canvas::write(std::string_view text, const Eigen::Vector2d& middle) {
  const Eigen::Vector2d corner = middle - half_size(text.size());
  for (const bool is_rim : {true, false}) {
    for (std::size_t s = 0; s < text.size(); ++s) {
      const auto glyph = glyph_of(text[s]);
      if (!glyph) continue;
      const int left =
          static_cast<int>(corner.x()) + kPixel * kStep * static_cast<int>(s);
      const int top = static_cast<int>(corner.y());
      const int rim = is_rim ? kPixel : 0;
      for (int row = 0; row < kRows; ++row) {
        for (int column = 0; column < kColumns; ++column) {
          const auto bits = (*glyph)[static_cast<std::size_t>(row)];
          if ((bits >> (kColumns - 1 - column) & 1) == 0) continue;
          for (int y = -rim; y < kPixel + rim; ++y) {
            for (int x = -rim; x < kPixel + rim; ++x) {
              set(left + kPixel * column + x, top + kPixel * row + y,
                  is_rim ? kWhite : kBlack);
            }
          }
        }
      }
    }
  }
}

Eigen::Vector2d half_size(std::size_t signs) {
  const double width = kPixel * (kStep * static_cast<double>(signs) - 1.0);
  return 0.5 * Eigen::Vector2d(width, kPixel * kRows);
}

}  // namespace clevis::report
