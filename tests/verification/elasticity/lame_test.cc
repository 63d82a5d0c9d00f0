// Thick cylinder under internal pressure (Lamé): exact curved geometry, real
// pressure load, orders of convergence. Source: docs/theory.md, anchors B2.

#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "elasticity/problem/displacement_basis.h"
#include "elasticity/solid/solid_solve.h"
#include "part/supports.h"
#include "stress/field/stress_history.h"
#include "support/annulus_mesh.h"
#include "support/convergence.h"
#include "support/field_error.h"

namespace clevis {
namespace {

using Eigen::Vector3d;

constexpr double kInner = 0.02;
constexpr double kOuter = 0.04;
constexpr double kPressure = 60e6;
const part::Material kSteel{"steel", 210e9, 0.3, 7850.0, 355e6};

/// Plane strain for dim = 3 (both faces held along z), plane stress for 2.
template <int dim>
support::ExactField exact_field() {
  const double ratio =
      kInner * kInner / (kOuter * kOuter - kInner * kInner) * kPressure;
  const double part = ratio * kOuter * kOuter;
  const double nu = kSteel.poissons_ratio;
  const double E = kSteel.youngs_modulus;
  support::ExactField exact;
  exact.stress = [=](const Vector3d& p) {
    const double r2 = p.head<2>().squaredNorm();
    return support::from_polar(ratio - part / r2, ratio + part / r2, 0.0,
                               dim == 3 ? 2 * nu * ratio : 0.0,
                               std::atan2(p.y(), p.x()));
  };
  exact.displacement = [=](const Vector3d& p) -> Vector3d {
    const double r = p.head<2>().norm();
    const double uniform = dim == 3 ? (1 + nu) * (1 - 2 * nu) : 1 - nu;
    const double u = (uniform * ratio * r + (1 + nu) * part / r) / E;
    return Vector3d(u * p.x() / r, u * p.y() / r, 0.0);
  };
  return exact;
}

template <int dim>
stress::InstantField solve_quarter(int cells, int degree) {
  const support::Annulus annulus{
      .inner = kInner, .outer = kOuter, .radial = cells, .angular = cells};
  const auto mesh = support::sector_mesh<dim>(annulus);
  loads::SurfaceLoad load;
  load.group = "x0";
  load.pressure = kPressure;
  const double force = kPressure * kInner * annulus.thickness;
  load.resultant.force = {force, force, 0.0};
  const double lever = dim == 3 ? annulus.thickness / 2 : 0.0;
  load.resultant.moment = {-lever * force, lever * force, 0.0};
  loads::LoadHistory history;
  history.instants.push_back({});
  history.instants[0].surface_loads.push_back(load);
  part::Supports fixed = {{"y0", {false, true, false}},
                          {"y1", {true, false, false}}};
  if (dim == 3) {
    fixed["z0"] = fixed["z1"] = {false, false, true};
  }
  const auto basis =
      elasticity::solve<dim>({mesh, kSteel, history, fixed, "tube"}, degree);
  return stress::instant_field<dim>(basis, kSteel, 6, 0);
}

template <int dim>
void expect_orders(int finest) {
  const auto exact = exact_field<dim>();
  for (int degree = 1; degree <= 4; ++degree) {
    std::vector<double> u_errors;
    std::vector<double> s_errors;
    for (int cells = 2; cells <= (degree == 4 ? 4 : finest); cells *= 2) {
      const auto error =
          support::field_error(solve_quarter<dim>(cells, degree), exact);
      u_errors.push_back(error.displacement);
      s_errors.push_back(error.stress);
    }
    const double s_rate = support::last_rate(s_errors);
    const double u_rate = support::last_rate(u_errors);
    std::printf(
        "dim %d, degree %d: stress %.1e order %.2f, displacement %.1e "
        "order %.2f\n",
        dim, degree, s_errors.back(), s_rate, u_errors.back(), u_rate);
    // At least the optimal order; this smooth field on a conformal mesh shows
    // one more with degree 4.
    EXPECT_GT(s_rate, degree - 0.15) << "stress, degree " << degree;
    EXPECT_GT(u_rate, degree + 1 - 0.15) << "displacement, degree " << degree;
  }
}

TEST(Lame, PlaneStressOrders) {
  expect_orders<2>(16);
}

TEST(Lame, PlaneStrainOrdersIn3D) {
  expect_orders<3>(8);
}

TEST(Lame, HoopStressAndBoreDisplacementAtDegreeFour) {
  const auto exact = exact_field<3>();
  const auto field = solve_quarter<3>(4, 4);
  // σ_θ(a) = 5/3 p for b = 2a.
  const double hoop = 5.0 / 3.0 * kPressure;
  double worst_stress = 0.0;
  double worst_u = 0.0;
  for (std::size_t c = 0; c < field.points.size(); ++c) {
    for (Eigen::Index q = 0; q < field.points[c].rows(); ++q) {
      const Vector3d at = field.points[c].row(q);
      if (at.head<2>().norm() > kInner * (1 + 1e-6)) continue;
      const double angle = std::atan2(at.y(), at.x());
      worst_stress = std::max(
          worst_stress,
          std::abs(support::hoop(field.stress[c], q, angle) / hoop - 1.0));
      const Vector3d u = exact.displacement(at);
      worst_u = std::max(
          worst_u,
          (field.displacement[c].row(q).transpose() - u).norm() / u.norm());
    }
  }
  std::printf("degree 4: hoop stress at the bore %.1e, displacement %.1e\n",
              worst_stress, worst_u);
  EXPECT_LT(worst_stress, 1e-5);
  EXPECT_GT(worst_stress, 0.0);
  EXPECT_LT(worst_u, 1e-6);
}

}  // namespace
}  // namespace clevis
