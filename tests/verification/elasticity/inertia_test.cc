// Free bars under their own inertia: polynomial solutions (anchors B7).

#include <cmath>

#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "elasticity/problem/displacement_basis.h"
#include "elasticity/solid/solid_solve.h"
#include "stress/field/stress_history.h"
#include "support/elastic_field_problem.h"
#include "support/field_error.h"
#include "support/structured_mesh.h"

namespace clevis {
namespace {

using Eigen::Vector3d;
using support::Vector6d;

/// No lateral contraction: the bar's axis decouples.
const part::Material kCork{"cork", 70e9, 0.0, 2700.0, 200e6};
const Vector3d kSize(0.3, 0.02, 0.01);

/// Box about `centre`; 2-D: a plate of the box's thickness.
template <int dim>
mesh::PartMesh<dim> box(const Vector3d& centre) {
  using Point = Eigen::Matrix<double, dim, 1>;
  std::array<int, dim> divisions{};
  divisions.fill(1);
  divisions[0] = 3;
  auto mesh =
      support::structured_mesh<dim>(divisions, 1, [&](const Point& x) -> Point {
        return centre.head<dim>() +
               kSize.head<dim>().cwiseProduct(x - Point::Constant(0.5));
      });
  if (dim == 2) mesh.thickness = kSize.z();
  return mesh;
}

template <int dim>
void expect_accelerating_bar() {
  const double pull = 40e6;
  const Vector3d centre(kSize.x() / 2, 0.0, 0.0);
  const auto mesh = box<dim>(centre);
  loads::LoadHistory history;
  history.instants.push_back({});
  auto& instant = history.instants[0];
  instant.rigid.acceleration.x() = pull / (kCork.density * kSize.x());
  loads::SurfaceLoad load;
  load.group = "x1";
  load.traction.x() = pull;
  load.resultant.force.x() = pull * kSize.y() * kSize.z();
  instant.surface_loads.push_back(load);
  const auto basis =
      elasticity::solve<dim>({mesh, kCork, history, {}, "bar"}, 2);
  EXPECT_LT(basis.checks.balance, 1e-13);
  support::ExactField exact;
  exact.stress = [&](const Vector3d& p) {
    Vector6d s = Vector6d::Zero();
    s[0] = pull * p.x() / kSize.x();
    return s;
  };
  EXPECT_LT(support::worst_stress_error(
                stress::instant_field<dim>(basis, kCork, 3, 0), exact),
            1e-10 * pull);
  // ½ ∫ σ²/E dV = σ0² A L / (6 E).
  EXPECT_NEAR(basis.strain_energy[0] /
                  (pull * pull * kSize.prod() / (6 * kCork.youngs_modulus)),
              1.0, 1e-11);
}

TEST(Inertia, AcceleratingBarIsLinear) {
  expect_accelerating_bar<2>();
  expect_accelerating_bar<3>();
}

template <int dim>
void expect_spinning_bar() {
  const double omega = 300.0;
  const auto mesh = box<dim>(Vector3d::Zero());
  loads::LoadHistory history;
  history.instants.push_back({});
  history.instants[0].rigid.omega.z() = omega;
  const auto basis =
      elasticity::solve<dim>({mesh, kCork, history, {}, "bar"}, 3);
  const double half = 0.5 * kCork.density * omega * omega;
  support::ExactField exact;
  exact.stress = [&](const Vector3d& p) {
    Vector6d s = Vector6d::Zero();
    for (int d = 0; d < 2; ++d) {
      s[d] = half * (0.25 * kSize[d] * kSize[d] - p[d] * p[d]);
    }
    return s;
  };
  EXPECT_LT(support::worst_stress_error(
                stress::instant_field<dim>(basis, kCork, 4, 0), exact),
            1e-9 * half * 0.25 * kSize.x() * kSize.x());
}

TEST(Inertia, SpinningBarIsParabolic) {
  expect_spinning_bar<2>();
  expect_spinning_bar<3>();
}

/// σ_xx = −ρ α x y and σ_xy = ρ α x²/2 balance the body force −ρ α × p; they
/// are compatible with a cubic displacement for ν = 0.
template <int dim>
void expect_angular_acceleration() {
  using Vector = Eigen::Matrix<double, dim, 1>;
  const double alpha = 2e4;
  const double scale = kCork.density * alpha;
  support::ExactField exact;
  exact.stress = [&](const Vector3d& p) {
    Vector6d s = Vector6d::Zero();
    s[0] = -scale * p.x() * p.y();
    s[3] = 0.5 * scale * p.x() * p.x();
    return s;
  };
  std::vector<support::TractionField<dim>> tractions;
  for (const char* group : {"x0", "x1", "y0", "y1"}) {
    tractions.push_back(
        {group, [&](const Vector& x, const Vector& n) -> Vector {
           const Vector6d s = exact.stress(Vector3d(x[0], x[1], 0.0));
           Vector t = Vector::Zero();
           t[0] = s[0] * n[0] + s[3] * n[1];
           t[1] = s[3] * n[0] + s[1] * n[1];
           return t;
         }});
  }
  const auto mesh = box<dim>(Vector3d(0.02, 0.01, 0.0));
  loads::LoadHistory history;
  history.instants.push_back({});
  history.instants[0].rigid.alpha.z() = alpha;
  const auto basis = support::solve_field<dim>(
      {mesh, kCork, history, {}, "bar"}, tractions, 3);
  const double largest = 0.5 * scale * 0.17 * 0.17;
  EXPECT_LT(support::worst_stress_error(
                stress::instant_field<dim>(basis, kCork, 4, 0), exact),
            1e-9 * largest);
}

TEST(Inertia, AngularAccelerationIsExactWithDegreeThree) {
  expect_angular_acceleration<2>();
  expect_angular_acceleration<3>();
}

TEST(Inertia, UnbalancedFreeBarIsRefused) {
  const auto mesh = box<2>(Vector3d::Zero());
  loads::LoadHistory history;
  history.instants.push_back({});
  history.instants[0].rigid.acceleration.x() = 10.0;
  try {
    elasticity::solve<2>({mesh, kCork, history, {}, "bar"}, 2);
    FAIL() << "a free part out of balance was solved";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "F003");
    EXPECT_NE(error.problem().find("inertia relief"), std::string::npos);
  }
}

}  // namespace
}  // namespace clevis
