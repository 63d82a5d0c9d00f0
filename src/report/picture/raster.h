#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "report/picture/surface.h"

namespace clevis::report {

/// Where a place is drawn: pixels = scale · sight · place + shift; the third
/// grows towards the eye.
struct Placement {
  Sight sight = Sight::Identity();
  double scale{};  ///< [pixel/mm]
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();

  /// Of a place [mm], y down [pixel].
  Eigen::Vector2d at(const Eigen::Vector3d& place) const;
};

/// A placement, and how high a picture it needs.
struct Fitted {
  Placement placement;
  double height{};  ///< [pixel]
};
/// Fits places [mm], as the sight turns them, into a picture of the given width
/// that is at most so high [pixel].
Fitted fitted(const Sight& sight, const Eigen::MatrixX3d& places, double width,
              double highest);

/// Triangles with their stress in colour, what is nearer before what is
/// farther, with the edges of the mesh where they are not crowded.
class Raster {
 public:
  Raster(int width, int height);

  /// @param largest  stress of the last colour [MPa].
  void draw(const Surface& surface, const Placement& placement, double largest);

  /// What is drawn from now on stands before all that was.
  void begin_layer();

  /// Which of the surfaces drawn, counted from 0, is in front at a pixel; -1:
  /// none.
  int front(int x, int y) const;

  /// Three bytes a pixel, row by row from the top.
  std::vector<std::uint8_t> rgb() const;

  /// The picture as PNG.
  std::string png() const;

 private:
  struct Corner {
    double x{}, y{}, z{}, stress{};
  };
  /// @param colour  in the place of the stress; null: none.
  void fill(const Corner& a, const Corner& b, const Corner& c, double light,
            double largest, const std::array<std::uint8_t, 3>* colour);
  void line(const Corner& a, const Corner& b, double bias);

  int width_, height_;  ///< of the finer grid
  std::vector<float> depth_;
  std::vector<int> front_;            ///< surface at each pixel of it, -1: none
  int drawn_ = 0;                     ///< surfaces
  std::vector<std::uint8_t> pixels_;  ///< RGB of the finer grid
};

/// Colours of the stress from the lowest to the highest, "RRGGBB".
std::vector<std::string> stress_colours();

}  // namespace clevis::report
