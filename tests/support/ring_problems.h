#pragma once

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "elasticity/direct/dissection.h"
#include "elasticity/problem/displacement_basis.h"
#include "elasticity/solid/solid_solve.h"
#include "part/supports.h"
#include "stress/field/stress_history.h"
#include "support/annulus_mesh.h"
#include "support/elastic_field_problem.h"
#include "support/field_error.h"

/// Quarters of a ring whose hoop stress on the bore is known, and how far a
/// solution is off there.
namespace clevis::support {

inline constexpr double kInner = 0.01;
inline constexpr double kThickness = 0.005;

inline part::Material steel(double poissons_ratio) {
  return {"steel", 210e9, poissons_ratio, 7850.0, 355e6};
}

struct Measured {
  int dofs{};
  double error{};  ///< of the peak, over the peak
  double flops{};  ///< of a factor of the stiffness matrix
};

template <int dim>
double factor_flops(const elasticity::Discretization<dim>& discretization) {
  return elasticity::dissect(discretization).flops * dim * dim * dim;
}

/// Largest difference of the hoop stress on the bore from `exact`, a function
/// of the angle, over `peak`.
template <int dim, class Exact>
Measured bore_error(const elasticity::DisplacementBasis<dim>& basis,
                    const part::Material& material, double peak,
                    const Exact& exact) {
  const auto field = stress::instant_field<dim>(basis, material, 8, 0);
  Measured measured{basis.discretization.dofs(), 0.0,
                    factor_flops(basis.discretization)};
  int found = 0;
  for (std::size_t c = 0; c < field.points.size(); ++c) {
    for (Eigen::Index q = 0; q < field.points[c].rows(); ++q) {
      const Eigen::Vector2d at = field.points[c].row(q).template head<2>();
      if (at.norm() > kInner * (1 + 1e-9)) continue;
      const double angle = std::atan2(at.y(), at.x());
      const double value = hoop(field.stress[c], q, angle);
      measured.error =
          std::max(measured.error, std::abs(value - exact(angle)) / peak);
      ++found;
    }
  }
  EXPECT_GT(found, 0);
  return measured;
}

/// Supports of a quarter on its cuts; in 3-D plane strain.
template <int dim>
part::Supports quarter_supports() {
  part::Supports fixed = {{"y0", {false, true, false}},
                          {"y1", {true, false, false}}};
  if (dim == 3) fixed["z0"] = fixed["z1"] = {false, false, true};
  return fixed;
}

/// Cells along either side, and how they are solved for.
struct Cells {
  int number{};
  mesh::CellShape shape = mesh::CellShape::kTensor;
  int degree = 4;
};

template <int dim>
mesh::PartMesh<dim> quarter(double outer, const Cells& cells) {
  return sector_mesh<dim>({.inner = kInner,
                           .outer = outer,
                           .thickness = kThickness,
                           .radial = cells.number,
                           .angular = cells.number,
                           .shape = cells.shape});
}

// ---- Kirsch: hole in an infinite plate under tension, anchors B1 ----------

template <int dim>
Measured kirsch(const Cells& cells) {
  using Vector = Eigen::Matrix<double, dim, 1>;
  const double tension = 50e6;
  const auto material = steel(0.3);
  const auto mesh = quarter<dim>(3 * kInner, cells);
  const TractionField<dim> rim{
      "x1", [&](const Vector& x, const Vector& n) -> Vector {
        const double angle = std::atan2(x[1], x[0]);
        const double q = kInner * kInner / x.template head<2>().squaredNorm();
        const double half = 0.5 * tension;
        const double c = std::cos(2 * angle);
        const auto s = from_polar(
            half * (1 - q) + half * (1 - 4 * q + 3 * q * q) * c,
            half * (1 + q) - half * (1 + 3 * q * q) * c,
            -half * (1 + 2 * q - 3 * q * q) * std::sin(2 * angle), 0.0, angle);
        Vector t = Vector::Zero();
        t[0] = s[0] * n[0] + s[3] * n[1];
        t[1] = s[3] * n[0] + s[1] * n[1];
        return t;
      }};
  const loads::LoadHistory none;
  const auto basis =
      solve_field<dim>({mesh, material, none, quarter_supports<dim>(), "plate"},
                       {rim}, cells.degree);
  return bore_error<dim>(basis, material, 3 * tension, [&](double angle) {
    return tension * (1 - 2 * std::cos(2 * angle));
  });
}

// ---- Lamé: tube under internal pressure, anchors B2 -----------------------

template <int dim>
Measured lame(const Cells& cells, double poissons_ratio) {
  const double pressure = 60e6;
  const auto material = steel(poissons_ratio);
  const auto mesh = quarter<dim>(2 * kInner, cells);
  loads::SurfaceLoad load;
  load.group = "x0";
  load.pressure = pressure;
  const double force = pressure * kInner * kThickness;
  load.resultant.force = {force, force, 0.0};
  const double lever = dim == 3 ? kThickness / 2 : 0.0;
  load.resultant.moment = {-lever * force, lever * force, 0.0};
  loads::LoadHistory history;
  history.instants.push_back({});
  history.instants[0].surface_loads.push_back(load);
  const auto basis = elasticity::solve<dim>(
      {mesh, material, history, quarter_supports<dim>(), "tube"}, cells.degree);
  const double hoop = 5.0 / 3.0 * pressure;  // (a² + b²)/(b² − a²), b = 2a
  return bore_error<dim>(basis, material, hoop, [&](double) {
    return hoop;
  });
}

// ---- Spinning ring and tube: inertia, anchors B7 --------------------------

template <int dim>
Measured spinning(const Cells& cells) {
  const double omega = 3000.0;
  const double nu = 0.3;
  const auto material = steel(nu);
  const double outer = 3 * kInner;
  const auto mesh = quarter<dim>(outer, cells);
  loads::LoadHistory history;
  history.instants.push_back({});
  history.instants[0].rigid.omega.z() = omega;
  const auto basis = elasticity::solve<dim>(
      {mesh, material, history, quarter_supports<dim>(), "ring"}, cells.degree);
  // Timoshenko & Goodier, rotating disks; plane strain by ν -> ν/(1 − ν).
  const double n = dim == 3 ? nu / (1 - nu) : nu;
  const double hoop = material.density * omega * omega / 4 *
                      ((3 + n) * outer * outer + (1 - n) * kInner * kInner);
  return bore_error<dim>(basis, material, hoop, [&](double) {
    return hoop;
  });
}

}  // namespace clevis::support
