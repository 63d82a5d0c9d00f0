#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/structured_mesh.h"

namespace clevis::support {

/// An L of two legs of width `width` whose re-entrant corner is rounded.
struct Fillet {
  double radius{};       ///< [m]
  double width = 0.01;   ///< of both legs [m]
  double length = 0.03;  ///< of both legs, from the corner [m]
  double thickness = 0.005;
  int along = 3;         ///< cells of a leg
  int around = 6;        ///< of the fillet, even
  int across = 4;        ///< from the fillet to the outside
  double grading = 1.0;  ///< larger: finer at the fillet
};

/// 0 … 1 onto itself, finer towards 0 by exp(strength).
inline double graded(double s, double strength) {
  return std::expm1(strength * s) / std::expm1(strength);
}

/// Legs along +x (below y = 0) and +y (left of x = 0); groups "x0" and "x1",
/// the legs' ends.
inline mesh::PartMesh<2> fillet_mesh(const Fillet& fillet) {
  using Eigen::Vector2d;
  const double r = fillet.radius;
  const double t = fillet.width;
  const double L = fillet.length;
  const int n = 2 * fillet.along + fillet.around;
  // Legs graded towards the fillet like the way across.
  const auto towards = [&](double s) {
    return graded(s, fillet.grading);
  };
  const auto inner_and_outer = [=](double s) {
    const double k = s * n;
    std::pair<Vector2d, Vector2d> ends;
    if (k <= fillet.along) {
      const double x = r + (L - r) * towards(1.0 - k / fillet.along);
      ends = {Vector2d(x, 0.0), Vector2d(x, -t)};
    } else if (k >= n - fillet.along) {
      const double y = r + (L - r) * towards(1.0 - (n - k) / fillet.along);
      ends = {Vector2d(0.0, y), Vector2d(-t, y)};
    } else {
      const double u = (k - fillet.along) / fillet.around;
      const double angle = (1.5 - 0.5 * u) * std::numbers::pi;
      const double way = 2.0 * u * (r + t);
      ends.first = Vector2d(r + r * std::cos(angle), r + r * std::sin(angle));
      ends.second =
          u < 0.5 ? Vector2d(r - way, -t) : Vector2d(-t, -t + way - (r + t));
    }
    return ends;
  };
  auto mesh = structured_mesh<2>({n, fillet.across}, 4,
                                 [&](const Vector2d& x) -> Vector2d {
                                   const auto [in, out] = inner_and_outer(x[0]);
                                   return in + towards(x[1]) * (out - in);
                                 });
  mesh.thickness = fillet.thickness;
  return mesh;
}

}  // namespace clevis::support
