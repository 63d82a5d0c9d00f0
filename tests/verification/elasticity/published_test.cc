// Published and textbook problems on plane meshes and thin 3-D strips, each
// with its source and tolerance. The printed lines "published, ..." are a
// table of results/studies/accuracy.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "elasticity/problem/displacement_basis.h"
#include "elasticity/solid/solid_solve.h"
#include "part/supports.h"
#include "stress/field/stress_history.h"
#include "support/annulus_mesh.h"
#include "support/elastic_field_problem.h"
#include "support/field_error.h"
#include "support/structured_mesh.h"

namespace clevis {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using support::Vector6d;

void expect_published(const char* problem, double value, double published,
                      double tolerance, int dofs) {
  std::printf("published, %s, %.6g, %.6g, %.2e, %.0e, %d\n", problem, value,
              published, value / published - 1, tolerance, dofs);
  EXPECT_NEAR(value / published, 1.0, tolerance) << problem;
}

/// Field value nearest to a point; the point is a lattice point of the mesh.
struct At {
  double distance = 1e300;
  Vector3d displacement;
  Vector6d stress;
};
At at_point(const stress::InstantField& field, const Vector3d& where) {
  At best;
  for (std::size_t c = 0; c < field.points.size(); ++c) {
    for (Eigen::Index q = 0; q < field.points[c].rows(); ++q) {
      const double distance =
          (field.points[c].row(q).transpose() - where).norm();
      if (distance >= best.distance) continue;
      best.distance = distance;
      best.displacement = field.displacement[c].row(q);
      best.stress = field.stress[c].row(q);
    }
  }
  EXPECT_LT(best.distance, 1e-6 * where.norm());
  return best;
}

// ---- Cook's membrane, anchors B5 ------------------------------------------

/// (0,0) (48,44) (48,60) (0,44), graded towards the clamped side with its
/// singular corners; 3-D: plane strain, unit thickness. The deflection is that
/// of the middle of the loaded side.
template <int dim>
double cook_deflection(const part::Material& material, int cells, int degree,
                       int& dofs) {
  using Vector = Eigen::Matrix<double, dim, 1>;
  std::array<int, dim> divisions{};
  divisions.fill(cells);
  if (dim == 3) divisions[dim - 1] = 1;
  auto mesh = support::structured_mesh<dim>(
      divisions, 1, [](const Vector& s) -> Vector {
        const double x = std::pow(s[0], 2);
        const double y = 0.5 * (1 - std::cos(std::numbers::pi * s[1]));
        Vector p;
        p[0] = 48 * x;
        p[1] = 44 * x + y * (44 - 28 * x);
        if constexpr (dim == 3) p[2] = s[2];
        return p;
      });
  if (dim == 2) mesh.thickness = 1.0;
  loads::LoadHistory history;
  history.instants.push_back({});
  loads::SurfaceLoad load;
  load.group = "x1";
  load.traction.y() = 1.0 / 16;
  load.resultant.force.y() = 1.0;
  load.resultant.moment =
      Vector3d(48, 52, dim == 3 ? 0.5 : 0.0).cross(load.resultant.force);
  history.instants[0].surface_loads.push_back(load);
  part::Supports fixed = {{"x0", {true, true, false}}};
  if (dim == 3) fixed["z0"] = fixed["z1"] = {false, false, true};
  const auto basis =
      elasticity::solve<dim>({mesh, material, history, fixed, "Cook"}, degree);
  dofs = basis.discretization.dofs();
  const auto field = stress::instant_field<dim>(basis, material, 1, 0);
  return at_point(field, Vector3d(48, 52, 0)).displacement.y();
}

TEST(Published, CooksMembrane) {
  int dofs = 0;
  const double value =
      cook_deflection<2>({"", 1.0, 1.0 / 3, 1.0, 1.0}, 16, 4, dofs);
  // Cook, Malkus & Plesha, Concepts and applications of FEA, 1989.
  expect_published("Cook's membrane; deflection at (48; 52)", value, 23.96,
                   1e-3, dofs);
}

// Volumetric locking would halve the deflection; the degrees agree.
TEST(Published, CooksMembraneNearlyIncompressible) {
  const part::Material rubber{"", 1.12499998125, 0.499999975, 1.0, 1.0};
  for (const int degree : {2, 3, 4}) {
    int dofs = 0;
    const double value =
        cook_deflection<3>(rubber, degree == 2 ? 24 : 12, degree, dofs);
    const auto name =
        "Cook's membrane; nu = 0.499999975; p = " + std::to_string(degree);
    expect_published(name.c_str(), value, 16.44, 2e-3, dofs);
  }
}

// ---- Beams: Timoshenko & Goodier, Theory of elasticity, §21 and §33 --------

/// Traction of a stress field on x0, x1, … of a mesh.
std::vector<support::TractionField<2>> tractions_of(
    const std::vector<std::string>& groups,
    const std::function<Vector6d(const Vector2d&)>& stress) {
  std::vector<support::TractionField<2>> result;
  for (const auto& group : groups) {
    result.push_back({group, [=](const Vector2d& x, const Vector2d& n) {
                        const Vector6d s = stress(x);
                        return Vector2d(s[0] * n[0] + s[3] * n[1],
                                        s[3] * n[0] + s[1] * n[1]);
                      }});
  }
  return result;
}

// Cantilever L = 48, D = 12, parabolic shear P = 1000 at the tip; the exact
// field is cubic. Anchors B6.
TEST(Published, CantileverUnderParabolicShear) {
  const double L = 48, D = 12, P = 1000, E = 3e7, nu = 0.3;
  const double I = D * D * D / 12;
  auto mesh = support::structured_mesh<2>({4, 2}, 1,
                                          [&](const Vector2d& x) -> Vector2d {
                                            return {L * x[0], D * (x[1] - 0.5)};
                                          });
  mesh.thickness = 1.0;
  const auto stress = [&](const Vector2d& x) {
    Vector6d s = Vector6d::Zero();
    s[0] = P * (L - x[0]) * x[1] / I;
    s[3] = -P / (2 * I) * (D * D / 4 - x[1] * x[1]);
    return s;
  };
  const part::Material material{"", E, nu, 1.0, 1e9};
  const loads::LoadHistory none;
  // Held at (0, 0) and, along x, at (0, ±D/2), where the exact field stands
  // still: u_x(0, y) vanishes at y = 0 and ±D/2.
  const auto discretization = elasticity::discretize<2>(mesh, 3);
  const auto node = [&](std::size_t vertex) {
    return 2 * discretization.vertex_nodes[vertex];
  };
  const auto basis = support::solve_field<2>(
      {mesh, material, none, {}, "beam"}, tractions_of({"x0", "x1"}, stress), 3,
      {node(5), node(5) + 1, node(10)});
  const auto tip = at_point(stress::instant_field<2>(basis, material, 2, 0),
                            Vector3d(L, 0, 0));
  const double exact =
      P / (6 * E * I) * ((4 + 5 * nu) * D * D * L / 4 + 2 * L * L * L);
  expect_published("cantilever; deflection of the tip",
                   std::abs(tip.displacement.y()), exact, 1e-9,
                   basis.discretization.dofs());
}

// Quarter of a ring, radial force P on one end, exact in polar coordinates.
TEST(Published, CurvedBeamUnderEndShear) {
  const double a = 0.02, b = 0.04, P = 1000;
  const double N = a * a - b * b + (a * a + b * b) * std::log(b / a);
  const part::Material material{"", 210e9, 0.3, 7850.0, 355e6};
  const auto stress = [=](const Vector2d& x) {
    const double r = x.norm();
    const double angle = std::atan2(x.y(), x.x());
    const double factor = P / N / 0.005;
    const double c = a * a * b * b / (r * r * r);
    const double d = (a * a + b * b) / r;
    return support::from_polar(factor * (r + c - d) * std::sin(angle),
                               factor * (3 * r - c - d) * std::sin(angle),
                               -factor * (r + c - d) * std::cos(angle), 0.0,
                               angle);
  };
  const auto mesh = support::sector_mesh<2>(
      {.inner = a, .outer = b, .thickness = 0.005, .radial = 8, .angular = 12});
  const loads::LoadHistory none;
  const auto basis =
      support::solve_field<2>({mesh, material, none, {}, "beam"},
                              tractions_of({"y0", "y1"}, stress), 4);
  const auto inner = at_point(stress::instant_field<2>(basis, material, 1, 0),
                              Vector3d(0, a, 0));
  expect_published("curved beam; stress at the root", inner.stress[0],
                   stress(Vector2d(0, a))[0], 1e-5,
                   basis.discretization.dofs());
}

// ---- Strip with a hole, d/H = 0.5: Howland, Phil. Trans. A 229, 1930 -----

/// Quarter of a strip with a hole in rays from its centre: `corner` cells to
/// the end, the others to the side.
mesh::PartMesh<2> strip_with_hole(double radius, const Vector2d& half_size,
                                  int corner, int others, int radial) {
  const double corner_angle = std::atan2(half_size.y(), half_size.x());
  auto mesh = support::structured_mesh<2>(
      {radial, corner + others}, 4, [=](const Vector2d& x) -> Vector2d {
        const double line = x[1] * (corner + others);
        const double angle =
            line <= corner
                ? corner_angle * line / corner
                : corner_angle + (std::numbers::pi / 2 - corner_angle) *
                                     (line - corner) / others;
        const double outer = line <= corner ? half_size.x() / std::cos(angle)
                                            : half_size.y() / std::sin(angle);
        const double r = radius * std::pow(outer / radius, x[0]);
        return {r * std::cos(angle), r * std::sin(angle)};
      });
  mesh.thickness = 0.005;
  return mesh;
}

// A strip with a hole of half its width, long enough (4 widths) that its ends
// do not matter: 2.16 on the net section by Howland's series, summed by hand
// to three digits; three times the cells on a strip twice as long give the
// same 2.1738.
TEST(Published, StripWithAHole) {
  const double radius = 0.01;
  const Vector2d half_size(0.08, 0.02);
  const double pull = 50e6;
  const auto mesh = strip_with_hole(radius, half_size, 2, 10, 8);
  const support::TractionField<2> end{
      "x1", [&](const Vector2d&, const Vector2d& n) -> Vector2d {
        return {n[0] > 0.5 ? pull : 0.0, 0.0};
      }};
  const part::Material material{"", 210e9, 0.3, 7850.0, 355e6};
  const loads::LoadHistory none;
  const auto basis = support::solve_field<2>(
      {mesh,
       material,
       none,
       {{"y0", {false, true, false}}, {"y1", {true, false, false}}},
       "strip"},
      {end}, 4);
  const auto top = at_point(stress::instant_field<2>(basis, material, 1, 0),
                            Vector3d(0, radius, 0));
  const double net = 1 - radius / half_size.y();
  expect_published("strip with a hole d/H = 0.5; net concentration",
                   net * top.stress[0] / pull, 2.16, 1e-2,
                   basis.discretization.dofs());
}

// ---- NAFEMS LE10: thick elliptic plate -------------------------------------

// 1 MPa on the upper face; the outer wall keeps x and y, and z on its middle
// line, which no group of faces can say: held node by node. σ_yy at D, the
// inner ellipse's end on the upper face: −5.38 MPa. A line support has no
// finite deflection in 3-D, so the stress at D still moves by 1e-3 when the
// mesh is refined.
TEST(Published, NafemsLe10) {
  auto mesh = support::structured_mesh<3>(
      {8, 8, 2}, 4, [](const Vector3d& s) -> Vector3d {
        const double angle = std::numbers::pi / 2 * s[1];
        const double x = 2.0 + 1.25 * s[0];
        const double y = 1.0 + 1.75 * s[0];
        return {x * std::cos(angle), y * std::sin(angle), 0.6 * s[2] - 0.3};
      });
  const support::TractionField<3> pressure{
      "z1", [](const Vector3d&, const Vector3d& n) -> Vector3d {
        return -1e6 * n;
      }};
  const auto discretization = elasticity::discretize<3>(mesh, 4);
  const auto positions = elasticity::node_positions(discretization);
  std::vector<int> held;
  for (Eigen::Index i = 0; i < positions.cols(); ++i) {
    const Vector3d at = positions.col(i);
    const bool outer = Vector2d(at.x() / 3.25, at.y() / 2.75).norm() > 1 - 1e-5;
    const int dof = 3 * static_cast<int>(i);
    if (outer || std::abs(at.x()) < 1e-9) held.push_back(dof);
    if (outer || std::abs(at.y()) < 1e-9) held.push_back(dof + 1);
    if (outer && std::abs(at.z()) < 1e-9) held.push_back(dof + 2);
  }
  const part::Material material{"", 210e9, 0.3, 7800.0, 355e6};
  const loads::LoadHistory none;
  const auto basis = support::solve_field<3>({mesh, material, none, {}, "LE10"},
                                             {pressure}, 4, held);
  const auto d = at_point(stress::instant_field<3>(basis, material, 1, 0),
                          Vector3d(2.0, 0.0, 0.3));
  expect_published("NAFEMS LE10; stress yy at D in MPa", d.stress[1] / 1e6,
                   -5.38, 2e-3, basis.discretization.dofs());
}

}  // namespace
}  // namespace clevis
