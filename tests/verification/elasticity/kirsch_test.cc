// Hole in an infinite plate under tension (Kirsch): the exact field's traction
// on the rim makes the finite problem exact. Source: anchors B1.

#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "part/supports.h"
#include "stress/field/stress_history.h"
#include "support/annulus_mesh.h"
#include "support/convergence.h"
#include "support/elastic_field_problem.h"
#include "support/field_error.h"

namespace clevis {
namespace {

using Eigen::Vector3d;
using support::Vector6d;

constexpr double kHole = 0.01;
constexpr double kTension = 50e6;
const part::Material kSteel{"steel", 210e9, 0.3, 7850.0, 355e6};

Vector6d exact_stress(const Vector3d& p, bool plane_strain) {
  const double angle = std::atan2(p.y(), p.x());
  const double q = kHole * kHole / p.head<2>().squaredNorm();
  const double half = 0.5 * kTension;
  const double c = std::cos(2 * angle);
  const double rr = half * (1 - q) + half * (1 - 4 * q + 3 * q * q) * c;
  const double tt = half * (1 + q) - half * (1 + 3 * q * q) * c;
  const double rt = -half * (1 + 2 * q - 3 * q * q) * std::sin(2 * angle);
  return support::from_polar(
      rr, tt, rt, plane_strain ? kSteel.poissons_ratio * (rr + tt) : 0.0,
      angle);
}

template <int dim>
stress::InstantField solve_quarter(int cells, int degree) {
  const auto mesh = support::sector_mesh<dim>(
      {.inner = kHole, .outer = 3 * kHole, .radial = cells, .angular = cells});
  using Vector = Eigen::Matrix<double, dim, 1>;
  const support::TractionField<dim> rim{
      "x1", [](const Vector& x, const Vector& n) -> Vector {
        const Vector6d s = exact_stress(Vector3d(x[0], x[1], 0.0), dim == 3);
        Vector t = Vector::Zero();
        t[0] = s[0] * n[0] + s[3] * n[1];
        t[1] = s[3] * n[0] + s[1] * n[1];
        return t;
      }};
  part::Supports fixed = {{"y0", {false, true, false}},
                          {"y1", {true, false, false}}};
  if (dim == 3) fixed["z0"] = fixed["z1"] = {false, false, true};
  const loads::LoadHistory none;
  const auto basis = support::solve_field<dim>(
      {mesh, kSteel, none, fixed, "plate"}, {rim}, degree);
  return stress::instant_field<dim>(basis, kSteel, 6, 0);
}

/// Hoop stress over the tension at 90° (peak) and 0° of the hole.
std::pair<double, double> hoop_extremes(const stress::InstantField& field) {
  std::pair<double, double> result;
  for (std::size_t c = 0; c < field.points.size(); ++c) {
    for (Eigen::Index q = 0; q < field.points[c].rows(); ++q) {
      const Vector3d at = field.points[c].row(q);
      const double s = field.stress[c](q, 0);
      if ((at.head<2>() - kHole * Eigen::Vector2d::UnitY()).norm() < 1e-9) {
        result.first = s / kTension;
      }
      if ((at.head<2>() - kHole * Eigen::Vector2d::UnitX()).norm() < 1e-9) {
        result.second = field.stress[c](q, 1) / kTension;
      }
    }
  }
  return result;
}

TEST(Kirsch, Orders) {
  support::ExactField exact;
  exact.stress = [](const Vector3d& p) {
    return exact_stress(p, false);
  };
  for (int degree = 1; degree <= 4; ++degree) {
    std::vector<double> errors;
    for (int cells = degree == 4 ? 2 : 4; cells <= (degree == 4 ? 8 : 16);
         cells *= 2) {
      errors.push_back(
          support::field_error(solve_quarter<2>(cells, degree), exact).stress);
    }
    const double rate = support::last_rate(errors);
    std::printf("degree %d: stress %.1e order %.2f\n", degree, errors.back(),
                rate);
    EXPECT_NEAR(rate, degree, 0.25) << "degree " << degree;
  }
}

TEST(Kirsch, PeakIsThreeTimesTheTension) {
  const auto [peak, least] = hoop_extremes(solve_quarter<2>(8, 4));
  std::printf("plane stress: peak %.6f, least %.6f\n", peak, least);
  EXPECT_NEAR(peak, 3.0, 3e-5);
  EXPECT_NEAR(least, -1.0, 3e-5);
}

TEST(Kirsch, PlaneStrainIn3D) {
  const auto field = solve_quarter<3>(6, 4);
  const auto [peak, least] = hoop_extremes(field);
  std::printf("plane strain in 3-D: peak %.6f, least %.6f\n", peak, least);
  EXPECT_NEAR(peak, 3.0, 2e-4);
  EXPECT_NEAR(least, -1.0, 2e-4);
  support::ExactField exact;
  exact.stress = [](const Vector3d& p) {
    return exact_stress(p, true);
  };
  EXPECT_LT(support::worst_stress_error(field, exact), 2e-4 * kTension);
}

}  // namespace
}  // namespace clevis
