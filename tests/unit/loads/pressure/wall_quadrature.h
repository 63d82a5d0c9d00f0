#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include <Eigen/Geometry>

#include "loads/history/load_history.h"
#include "part/bore.h"

namespace clevis::loads {

/// Gauss–Legendre points on (-1, 1) by Newton on the Legendre polynomial.
template <int n>
std::array<std::array<double, 2>, n> gauss_points() {
  std::array<std::array<double, 2>, n> points{};
  for (int i = 0; i < n; ++i) {
    double x = std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5));
    double slope = 1.0;
    for (int k = 0; k < 50; ++k) {
      double p = 1.0, before = 0.0;
      for (int j = 0; j < n; ++j) {
        const double next = ((2 * j + 1) * x * p - j * before) / (j + 1);
        before = p;
        p = next;
      }
      slope = n * (x * p - before) / (x * x - 1.0);
      x -= p / slope;
    }
    points[static_cast<std::size_t>(i)] = {
        x, 2.0 / ((1.0 - x * x) * slope * slope)};
  }
  return points;
}

/// Resultant about the middle of the axis of a traction on a cylinder, with
/// cells that end where the loaded half ends (normal to kink_direction(s)).
inline Wrench integrate_over_wall(
    const part::Bore& bore,
    const std::function<Eigen::Vector3d(double)>& kink_direction,
    const std::function<Eigen::Vector3d(
        const Eigen::Vector3d& p_LQ, const Eigen::Vector3d& e_r)>& traction) {
  constexpr int kPoints = 24;
  const auto gauss = gauss_points<kPoints>();
  Wrench sum;
  for (const auto& [x, weight_s] : gauss) {
    const double s = 0.5 * bore.length * x;
    const Eigen::Vector3d e_1 = kink_direction(s).normalized();
    const Eigen::Vector3d e_2 = bore.axis_L.cross(e_1);
    for (int half = 0; half < 2; ++half) {
      for (const auto& [y, weight_t] : gauss) {
        const double theta = std::numbers::pi * (half + 0.5 * y);
        const Eigen::Vector3d e_r =
            std::cos(theta) * e_1 + std::sin(theta) * e_2;
        const Eigen::Vector3d p_CQ = s * bore.axis_L + bore.radius * e_r;
        const double dA = 0.5 * bore.length * weight_s * bore.radius * 0.5 *
                          std::numbers::pi * weight_t;
        const Eigen::Vector3d force = dA * traction(bore.p_LC + p_CQ, e_r);
        sum.force += force;
        sum.moment += p_CQ.cross(force);
      }
    }
  }
  return sum;
}

}  // namespace clevis::loads
