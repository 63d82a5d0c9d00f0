// Solids of revolution by Fourier terms on the meridian, against closed forms
// and against hexahedra. Source: docs/theory.md, "Solids of revolution".

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "base/values/stopwatch.h"
#include "elasticity/revolution/revolution_solve.h"
#include "elasticity/solid/solid_solve.h"
#include "stress/field/stress_history.h"
#include "support/annulus_mesh.h"
#include "support/field_error.h"

namespace clevis {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;

const part::Material kSteel{"steel", 210e9, 0.3, 7850.0, 355e6};

/// A tube (or bar, inner = 0) along x from 0 to length; groups x0, x1 its ends,
/// y0 the bore, y1 the outside. Angles count from y.
mesh::Revolution tube(double inner, double outer, double length,
                      std::array<int, 2> cells) {
  mesh::Revolution solid;
  solid.meridian =
      support::structured_mesh<2>(cells, 2, [=](const Vector2d& x) {
        return Vector2d(length * x[0], inner + (outer - inner) * x[1]);
      });
  solid.meridian.thickness = 1.0;
  solid.origin = Vector3d::Zero();
  solid.axes.setIdentity();
  return solid;
}

loads::LoadHistory one_instant() {
  loads::LoadHistory history;
  history.instants.push_back({});
  return history;
}

void add_seat(loads::LoadHistory& history, const std::string& group,
              loads::SeatKind kind, const Vector3d& at,
              const loads::Wrench& wrench) {
  loads::Seat seat;
  seat.name = seat.group = group;
  seat.kind = kind;
  seat.p_LS = at;
  history.seats.push_back(seat);
  history.instants[0].wrenches.push_back(wrench);
}

constexpr double kRadius = 0.01;
constexpr double kLength = 0.05;

/// Stress of a round bar whose ends are pulled by linear tractions.
stress::InstantField loaded_bar(const loads::Wrench& wrench, int degree) {
  const auto solid = tube(0.0, kRadius, kLength, {4, 2});
  auto history = one_instant();
  add_seat(history, "x1", loads::SeatKind::kTraction, {kLength, 0, 0}, wrench);
  add_seat(history, "x0", loads::SeatKind::kTraction, {0, 0, 0},
           {-wrench.force, -wrench.moment});
  const auto solution =
      elasticity::solve_revolution({solid, kSteel, history, {}, "bar"}, degree);
  std::printf("%d terms, %d equations; relief %.1e, residual %.1e\n",
              solution.terms, solution.basis.equations,
              solution.basis.checks.relief, solution.basis.checks.residual);
  return stress::instant_field<3>(solution.basis, kSteel, 4, 0);
}

constexpr double kArea = pi * kRadius * kRadius;
constexpr double kInertia = pi * kRadius * kRadius * kRadius * kRadius / 4.0;

/// Largest stress errors over `scale` in cells off the axis, and in those on
/// it, where slopes are taken a millionth of a cell away.
struct Errors {
  double beside{}, on_axis{};
};

Errors relative_errors(
    const stress::InstantField& field,
    const std::function<support::Vector6d(const Vector3d&)>& exact,
    double scale) {
  Errors errors;
  for (std::size_t c = 0; c < field.points.size(); ++c) {
    const bool touches_axis =
        field.points[c].rightCols<2>().rowwise().norm().minCoeff() <
        1e-9 * kRadius;
    for (Eigen::Index q = 0; q < field.points[c].rows(); ++q) {
      const Vector3d p = field.points[c].row(q);
      const double error =
          (field.stress[c].row(q).transpose() - exact(p)).cwiseAbs().maxCoeff();
      double& worst = touches_axis ? errors.on_axis : errors.beside;
      worst = std::max(worst, error / scale);
    }
  }
  std::printf("largest error %.1e, on the axis %.1e of the peak\n",
              errors.beside, errors.on_axis);
  return errors;
}

void expect_exact(const Errors& errors) {
  EXPECT_LT(errors.beside, 1e-9);
  EXPECT_LT(errors.on_axis, 1e-5);
}

TEST(Revolution, TensionBendingAndTorsionOfABarAreExact) {
  const double force = 1e4;
  const auto tension = loaded_bar({{force, 0, 0}, Vector3d::Zero()}, 1);
  expect_exact(relative_errors(
      tension,
      [&](const Vector3d&) {
        support::Vector6d s = support::Vector6d::Zero();
        s[0] = force / kArea;
        return s;
      },
      force / kArea));
  const double moment = 100.0;
  const Vector3d about(0.0, 0.6, 0.8);
  const auto bending = loaded_bar({Vector3d::Zero(), moment * about}, 2);
  expect_exact(relative_errors(
      bending,
      [&](const Vector3d& p) {
        support::Vector6d s = support::Vector6d::Zero();
        s[0] = moment / kInertia * about.cross(p).x();
        return s;
      },
      moment * kRadius / kInertia));
  const auto torsion = loaded_bar({Vector3d::Zero(), {moment, 0, 0}}, 1);
  expect_exact(relative_errors(
      torsion,
      [&](const Vector3d& p) {
        const double slope = moment / (2.0 * kInertia);
        support::Vector6d s = support::Vector6d::Zero();
        s[3] = -slope * p.z();
        s[5] = slope * p.y();
        return s;
      },
      moment * kRadius / (2.0 * kInertia)));
}

/// A turning ring bonded to a rigid shaft between rigid walls (plane strain):
/// u = A r + B / r − c r³ with c = ρω²/(8 (λ + 2μ)), u(a) = 0, σ_r(b) = 0.
TEST(Revolution, TurningRingOnARigidShaft) {
  const double a = 0.02;
  const double b = 0.04;
  const auto solid = tube(a, b, 0.03, {1, 10});
  auto history = one_instant();
  const double omega = 2000.0;
  history.instants[0].rigid.omega = {omega, 0.0, 0.0};
  const auto solution =
      elasticity::solve_revolution({solid,
                                    kSteel,
                                    history,
                                    {{"x0", {true, false, false}},
                                     {"x1", {true, false, false}},
                                     {"y0", {false, true, true}}},
                                    "ring"},
                                   4);
  EXPECT_EQ(solution.terms, 1);
  const auto lame = elasticity::lame_constants<3>(kSteel);
  const double stiff = lame.lambda + 2.0 * lame.mu;
  const double c = kSteel.density * omega * omega / (8.0 * stiff);
  // σ_r/μ' at b: 2 (λ + μ) A − 2 μ B/b² = c b² (3 (λ + 2μ) + λ), B = c a⁴ − A
  // a²
  const double b2 = b * b;
  const double a2 = a * a;
  const double A = (c * b2 * (3.0 * stiff + lame.lambda) +
                    2.0 * lame.mu * c * a2 * a2 / b2) /
                   (2.0 * (lame.lambda + lame.mu) + 2.0 * lame.mu * a2 / b2);
  const double B = c * a2 * a2 - A * a2;
  const auto field = stress::instant_field<3>(solution.basis, kSteel, 4, 0);
  double worst = 0.0;
  double largest = 0.0;
  for (std::size_t k = 0; k < field.points.size(); ++k) {
    for (Eigen::Index q = 0; q < field.points[k].rows(); ++q) {
      const Vector3d p = field.points[k].row(q);
      const double r = p.tail<2>().norm();
      const double slope = A - B / (r * r) - 3.0 * c * r * r;
      const double ratio = A + B / (r * r) - c * r * r;
      const double radial = stiff * slope + lame.lambda * ratio;
      const double hoop = stiff * ratio + lame.lambda * slope;
      const double axial = lame.lambda * (slope + ratio);
      const double trace = field.stress[k].row(q).head<3>().sum();
      worst = std::max(worst, std::abs(trace - radial - hoop - axial));
      worst = std::max(worst, std::abs(field.stress[k](q, 0) - axial));
      const Vector3d e(0.0, p.y() / r, p.z() / r);
      const double found = e.y() * e.y() * field.stress[k](q, 1) +
                           e.z() * e.z() * field.stress[k](q, 2) +
                           2.0 * e.y() * e.z() * field.stress[k](q, 4);
      worst = std::max(worst, std::abs(found - radial));
      largest = std::max({largest, std::abs(radial), std::abs(hoop)});
    }
  }
  std::printf("turning ring: %d equations, largest error %.1e of the peak\n",
              solution.basis.equations, worst / largest);
  EXPECT_LT(worst, 1e-5 * largest);
}

/// A hexahedral ring pressed by a pin in its bore and a seat outside: the
/// meridian found in it gives what the hexahedra give.
TEST(Revolution, PressedRingAgreesWithHexahedra) {
  const support::Annulus shape{.inner = 0.02,
                               .outer = 0.04,
                               .thickness = 0.02,
                               .start = 0.3,
                               .radial = 3,
                               .angular = 16,
                               .axial = 2};
  auto mesh = support::ring_mesh<3>(shape);
  mesh.groups[1].cylinder = mesh.groups[0].cylinder;
  mesh.groups[1].cylinder->radius = shape.outer;
  const auto solid = mesh::find_revolution(mesh);
  ASSERT_TRUE(solid);
  EXPECT_EQ(solid->meridian.cells.size(), 6U);
  auto history = one_instant();
  const Vector3d middle(0.0, 0.0, shape.thickness / 2);
  const Vector3d force = 20e3 * Vector3d(std::cos(0.7), std::sin(0.7), 0.0);
  add_seat(history, "x0", loads::SeatKind::kBearing, middle,
           {force, {3.0, -5.0, 2.0}});
  add_seat(history, "x1", loads::SeatKind::kBearing, middle,
           {-force, {-3.0, 5.0, -2.0}});
  Stopwatch watch;
  const auto hexahedra =
      elasticity::solve<3>({mesh, kSteel, history, {}, "ring"}, 4);
  std::printf("hexahedra %.2f s\n", watch.lap());
  const auto terms =
      elasticity::solve_revolution({*solid, kSteel, history, {}, "ring"}, 4);
  const auto peak = [&](const auto& basis) {
    return stress::stress_history<3>(basis, kSteel, 4).largest();
  };
  const double of_hexahedra = peak(hexahedra);
  const auto& seconds = terms.basis.seconds;
  std::printf("terms: assembly %.2f s, solve %.2f s, sum %.2f s\n",
              seconds.assemble, seconds.factor, seconds.solve);
  watch.lap();
  const double of_terms = peak(terms.basis);
  std::printf("its peak %.2f s\n", watch.lap());
  std::printf(
      "pressed ring: %d terms, %d equations, peak %.6g, energy %.8g; "
      "hexahedra %d equations, peak %.6g, energy %.8g\n",
      terms.terms, terms.basis.equations, of_terms,
      terms.basis.strain_energy[0], hexahedra.discretization.dofs(),
      of_hexahedra, hexahedra.strain_energy[0]);
  EXPECT_NEAR(of_terms / of_hexahedra, 1.0, 1e-3);
  EXPECT_NEAR(terms.basis.strain_energy[0] / hexahedra.strain_energy[0], 1.0,
              1e-4);
}

}  // namespace
}  // namespace clevis
