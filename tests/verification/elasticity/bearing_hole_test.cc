// Hole in an infinite plate pressed by a pin with cosine pressure: the hole is
// loaded through the library's bearing seat, the rim takes the exact traction.
// Source: docs/theory.md, "Bearing load"; anchors B3.

#include <array>
#include <cmath>
#include <complex>
#include <cstdio>
#include <numbers>

#include <gtest/gtest.h>

#include "stress/field/stress_history.h"
#include "support/annulus_mesh.h"
#include "support/convergence.h"
#include "support/elastic_field_problem.h"
#include "support/field_error.h"

namespace clevis {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;
using Complex = std::complex<double>;

constexpr double kRadius = 0.01;
constexpr double kThickness = 0.008;
constexpr double kForce = 5000.0;
constexpr double kPressure = 2.0 * kForce / (pi * kRadius * kThickness);
const part::Material kSteel{"steel", 210e9, 0.3, 7850.0, 355e6};
constexpr double kKappa = (3.0 - 0.3) / (1.0 + 0.3);  // plane stress

/// xx, yy, xy by Muskhelishvili's potentials as series; for r >= 2 R.
Vector3d exact_stress(const Vector2d& at) {
  constexpr int kTerms = 40;
  const Complex z(at.x(), at.y());
  const Complex w = kRadius / z;
  Complex phi = -kPressure / (4 * (1 + kKappa)) * w;
  Complex slope = -phi / z;
  Complex psi = kPressure * kKappa / (4 * (1 + kKappa)) * w +
                kPressure / pi * w * w +
                kPressure * (0.25 - 1 / (2 * (1 + kKappa))) * w * w * w;
  for (int m = 1; m <= kTerms; ++m) {
    const double a =
        (m % 2 == 1 ? -1.0 : 1.0) * kPressure / pi / (4.0 * m * m - 1.0);
    const Complex power = a * std::pow(w, 2 * m);
    phi += power;
    slope -= 2.0 * m * power / z;
    psi += 2.0 * m * power * w * w;
  }
  // σ_y − σ_x + 2i τ_xy = 2 (z̄ Φ' + Ψ), σ_x + σ_y = 4 Re Φ.
  const double sum = 4.0 * phi.real();
  const Complex difference = 2.0 * (std::conj(z) * slope + psi);
  return {0.5 * (sum - difference.real()), 0.5 * (sum + difference.real()),
          0.5 * difference.imag()};
}

/// σ_θ / p_0 on the edge of the hole, θ from the force.
double exact_hoop(double angle) {
  const double c = std::cos(angle);
  return 2 / pi + kKappa / (1 + kKappa) * c - std::max(0.0, c);
}

/// Ring of radii 1 : 4; `turn` in cells moves the mesh lines off ±90°.
stress::InstantField solve_ring(int angular, double turn, int degree) {
  const auto mesh = support::ring_mesh<2>({.inner = kRadius,
                                           .outer = 4 * kRadius,
                                           .thickness = kThickness,
                                           .start = turn * 2 * pi / angular,
                                           .radial = angular / 4,
                                           .angular = angular});
  loads::LoadHistory history;
  loads::Seat seat;
  seat.name = seat.group = "x0";
  seat.kind = loads::SeatKind::kBearing;
  history.seats.push_back(seat);
  history.instants.push_back({});
  history.instants[0].wrenches.push_back({{kForce, 0, 0}, Vector3d::Zero()});
  const support::TractionField<2> rim{
      "x1", [](const Vector2d& x, const Vector2d& n) -> Vector2d {
        const Vector3d s = exact_stress(x);
        return {s[0] * n[0] + s[2] * n[1], s[2] * n[0] + s[1] * n[1]};
      }};
  const auto basis = support::solve_field<2>(
      {mesh, kSteel, history, {}, "ring"}, {rim}, degree);
  return stress::instant_field<2>(basis, kSteel, 8, 0);
}

/// Hoop stress over p_0 at lattice points of the edge: (angle, value).
std::vector<std::pair<double, double>> edge_hoop(
    const stress::InstantField& field) {
  std::vector<std::pair<double, double>> result;
  for (std::size_t c = 0; c < field.points.size(); ++c) {
    for (Eigen::Index q = 0; q < field.points[c].rows(); ++q) {
      const Vector3d at = field.points[c].row(q);
      if (at.head<2>().norm() > kRadius * (1 + 1e-6)) continue;
      const double angle = std::atan2(at.y(), at.x());
      result.emplace_back(angle,
                          support::hoop(field.stress[c], q, angle) / kPressure);
    }
  }
  return result;
}

/// Root mean square error of the hoop stress on the edge, over p_0.
double edge_error(const std::vector<std::pair<double, double>>& edge) {
  double sum = 0.0;
  for (const auto& [angle, value] : edge) {
    sum += std::pow(value - exact_hoop(angle), 2);
  }
  return std::sqrt(sum / static_cast<double>(edge.size()));
}

/// Largest hoop stress in units of P / (D t).
double peak(const std::vector<std::pair<double, double>>& edge) {
  double largest = 0.0;
  for (const auto& entry : edge) largest = std::max(largest, entry.second);
  return largest * kPressure / (kForce / (2 * kRadius * kThickness));
}

TEST(BearingHole, HoopStressAroundTheEdge) {
  const auto edge = edge_hoop(solve_ring(32, 0.0, 4));
  const std::pair<double, double> values[] = {
      {0, 0.31162}, {45, 0.40681}, {135, 0.15932}, {180, -0.03838}};
  for (const auto& [degrees, value] : values) {
    int found = 0;
    for (const auto& [angle, hoop] : edge) {
      if (std::abs(std::abs(angle) - degrees * pi / 180) > 1e-9) continue;
      EXPECT_NEAR(hoop, value, 3e-5) << degrees;
      ++found;
    }
    EXPECT_GE(found, 2) << degrees;
  }
}

// The peak lies on the kink of the pressure, where stress behaves like
// s log s: the error halves with the mesh and no faster, whatever the degree.
TEST(BearingHole, PeakTendsToEightOverPiSquared) {
  std::array<double, 3> peaks{};
  for (std::size_t k = 0; k < 3; ++k) {
    peaks[k] = peak(edge_hoop(solve_ring(16 << k, 0.0, 4)));
  }
  const double first = peaks[1] - peaks[0];
  const double second = peaks[2] - peaks[1];
  const double limit = peaks[2] + second * second / (first - second);
  std::printf("peak %.6f %.6f %.6f, limit %.6f P/(D t)\n", peaks[0], peaks[1],
              peaks[2], limit);
  EXPECT_NEAR(peaks[2], 0.810569, 1.5e-3 * 0.810569);
  EXPECT_NEAR(limit, 0.810569, 3e-4 * 0.810569);
}

// A mesh line on the kink helps by a constant; the order stays.
TEST(BearingHole, ConvergesWithAndWithoutAMeshLineOnTheKink) {
  for (int degree = 2; degree <= 4; ++degree) {
    std::array<double, 2> finest{};
    for (const int half_cells : {0, 1}) {
      std::vector<double> errors;
      for (int angular : {16, 32, 64}) {
        const auto field = solve_ring(angular, 0.5 * half_cells, degree);
        errors.push_back(edge_error(edge_hoop(field)));
      }
      const double rate = support::last_rate(errors);
      std::printf(
          "degree %d, turned by %d/2 cell: hoop %.1e %.1e %.1e, order "
          "%.2f\n",
          degree, half_cells, errors[0], errors[1], errors[2], rate);
      EXPECT_NEAR(rate, 1.5, 0.3)
          << "degree " << degree << ", turned by " << half_cells << "/2 cell";
      finest[static_cast<std::size_t>(half_cells)] = errors.back();
    }
    EXPECT_LT(finest[0], finest[1]) << "degree " << degree;
  }
}

}  // namespace
}  // namespace clevis
