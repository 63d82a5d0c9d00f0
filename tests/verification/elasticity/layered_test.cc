// Plates by Legendre terms through the thickness: against the general hexes'
// own stiffness, polynomial solutions, and thick eyes in 3-D.

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "elasticity/assembly/stiffness.h"
#include "elasticity/assembly/supports.h"
#include "elasticity/plate/layered_solve.h"
#include "elasticity/plate/layered_stiffness.h"
#include "elasticity/plate/plate_layer.h"
#include "elasticity/solid/solid_solve.h"
#include "part/supports.h"
#include "stress/field/probe.h"
#include "stress/field/stress_history.h"
#include "support/eye_problem.h"

namespace clevis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using elasticity::Parity;

const part::Material kSteel{"steel", 210e9, 0.3, 7850.0, 355e6};

MatrixXd dense(const elasticity::UpperTriangle& upper) {
  MatrixXd full = MatrixXd::Zero(upper.rows(), upper.rows());
  for (int i = 0; i < upper.rows(); ++i) {
    const auto row = static_cast<std::size_t>(i);
    for (int k = upper.row_start[row]; k < upper.row_start[row + 1]; ++k) {
      const auto at = static_cast<std::size_t>(k);
      full(i, upper.column[at]) = full(upper.column[at], i) = upper.value[at];
    }
  }
  return full;
}

/// A curved plate: sector of a ring, not in the plane z = 0.
mesh::PartMesh<2> curved_plate() {
  auto mesh = support::sector_mesh<2>({.inner = 0.01,
                                       .outer = 0.03,
                                       .thickness = 0.012,
                                       .radial = 2,
                                       .angular = 2,
                                       .degree = 3});
  mesh.mid_plane_z = 0.002;
  return mesh;
}

// The Kronecker sums are Tᵀ K T of the layer's hexahedra, whose matrix knows
// nothing of them; and rigid motions are free of force.
TEST(Layered, StiffnessIsTheReducedStiffnessOfTheHexahedra) {
  constexpr int kTerms = 2;
  const auto plane = elasticity::discretize<2>(curved_plate(), 3);
  const auto layer = elasticity::layer_over(plane, 2 * kTerms - 1);
  const auto hexahedra = elasticity::assemble_stiffness(layer, kSteel, "test");
  const auto integrals = elasticity::plane_integrals(plane, "test");
  for (const Parity parity : {Parity::kStretching, Parity::kBending}) {
    const elasticity::ThicknessReduction reduction(parity, kTerms);
    const MatrixXd reduced = dense(elasticity::layered_stiffness(
        integrals, kSteel, parity, kTerms, plane.thickness));
    const MatrixXd terms = MatrixXd::Random(reduced.rows(), 3);
    const MatrixXd wanted =
        reduction.reduce(hexahedra.multiply(reduction.expand(terms)));
    EXPECT_LT((reduced * terms - wanted).norm(), 1e-11 * wanted.norm());

    const auto positions = elasticity::node_positions(layer);
    const MatrixXd rigid = elasticity::rigid_modes<3>(
        positions, Vector3d(0.0, 0.0, plane.mid_plane_z), 0.02);
    const MatrixXd own = reduction.expand(reduction.rigid_modes(
        elasticity::node_positions(plane), plane.thickness));
    const MatrixXd known = rigid * rigid.colPivHouseholderQr().solve(own);
    EXPECT_EQ(own.colPivHouseholderQr().rank(), 3);
    EXPECT_LT((own - known).norm(), 1e-12 * own.norm());
    const MatrixXd mass_free =
        reduction.expand(MatrixXd::Identity(reduced.rows(), reduced.rows()));
    for (Index mode = 0; mode < 6; ++mode) {
      const bool stretches = mode == 0 || mode == 1 || mode == 5;
      if (stretches != (parity == Parity::kStretching)) continue;
      const MatrixXd v = mass_free.colPivHouseholderQr().solve(rigid.col(mode));
      ASSERT_LT((mass_free * v - rigid.col(mode)).norm(), 1e-10);
      EXPECT_LT((reduced * v).norm(), 1e-9 * reduced.norm() * v.norm());
    }
  }
}

/// A plate 60 × 10 mm whose ends take a wrench each, opposite.
elasticity::DisplacementBasis<3> bar(double thickness, const Vector3d& force,
                                     const Vector3d& moment) {
  const Vector2d size(0.06, 0.01);
  auto mesh = support::structured_mesh<2>({2, 1}, 1,
                                          [&](const Vector2d& x) -> Vector2d {
                                            return size.cwiseProduct(x);
                                          });
  mesh.thickness = thickness;
  mesh.mid_plane_z = 0.5 * thickness;
  loads::LoadHistory history;
  loads::InstantLoad instant;
  for (const auto& [name, side] : {std::pair{"x0", -1.0}, {"x1", 1.0}}) {
    loads::Seat seat;
    seat.name = seat.group = name;
    seat.kind = loads::SeatKind::kTraction;
    seat.p_LS = {side < 0 ? 0.0 : size[0], size[1] / 2, thickness / 2};
    history.seats.push_back(seat);
    instant.wrenches.push_back({side * force, side * moment});
  }
  history.instants.push_back(instant);
  return elasticity::solve_layered({mesh, kSteel, history, {}, "bar"}, 2, 2);
}

// Tension, bending in the plane and out of it, together: sigma_xx alone,
// linear, with free contraction and anticlastic curvature.
TEST(Layered, TensionAndBendingBothWaysAreExact) {
  const double t = 0.008;
  const double b = 0.01;
  const double force = 900.0;
  const double in_plane = 4.0;
  const double out_of_plane = 3.0;
  const auto basis = bar(t, {force, 0.0, 0.0}, {0.0, out_of_plane, in_plane});
  EXPECT_EQ(basis.columns.cols(), 2);  // one of each parity
  const auto field = stress::instant_field<3>(basis, kSteel, 2, 0);
  const double peak = force / (b * t) + 6 * in_plane / (t * b * b) +
                      6 * out_of_plane / (b * t * t);
  for (std::size_t c = 0; c < field.points.size(); ++c) {
    for (Index q = 0; q < field.points[c].rows(); ++q) {
      const double exact =
          force / (b * t) -
          12 * in_plane / (t * b * b * b) * (field.points[c](q, 1) - b / 2) +
          12 * out_of_plane / (b * t * t * t) * (field.points[c](q, 2) - t / 2);
      EXPECT_NEAR(field.stress[c](q, 0), exact, 1e-10 * peak);
      for (int k = 1; k < 6; ++k) {
        EXPECT_NEAR(field.stress[c](q, k), 0.0, 1e-10 * peak);
      }
    }
  }
}

/// The eye of support/eye_problem.h, as a plate: forces across the plane and
/// moments of all directions included.
struct ThickEye {
  support::EyeProblem solid = support::eye_problem(2, 4);
  mesh::PartMesh<2> plate;
  ThickEye() {
    support::Annulus ring{.inner = 0.01,
                          .outer = 0.02,
                          .thickness = 0.008,
                          .radial = 1,
                          .angular = 8,
                          .axial = 2,
                          .degree = 4};
    solid.mesh = support::ring_mesh<3>(ring);
    plate = support::ring_mesh<2>(ring);
    plate.mid_plane_z = 0.004;
    plate.groups[0].cylinder = solid.mesh.groups[0].cylinder;
  }
};

// The general hexes converge to the same field: energy and peak within 1e-3.
TEST(Layered, ThickEyeUnderGeneralLoadsMatchesHexahedra) {
  const ThickEye eye;
  const auto solid = elasticity::solve<3>(eye.solid.problem(), 4);
  const auto layered = elasticity::solve_layered(
      {eye.plate, eye.solid.material, eye.solid.history, {}, "eye"}, 4, 4);
  for (Index i = 0; i < 2; ++i) {
    EXPECT_NEAR(layered.strain_energy[i] / solid.strain_energy[i], 1.0, 1e-3);
  }
  const auto want = stress::stress_history<3>(solid, eye.solid.material, 4);
  const auto got = stress::stress_history<3>(layered, eye.solid.material, 8);
  EXPECT_NEAR(got.largest() / want.largest(), 1.0, 1e-3);
}

// Held on a side, also across the plate: the supports of a case.
TEST(Layered, FixedSidesMatchHexahedra) {
  ThickEye eye;
  const part::Supports fixed = {{"x0", {true, true, true}}};
  auto problem = eye.solid.problem();
  auto history = eye.solid.history;
  history.seats.erase(history.seats.begin());
  for (auto& instant : history.instants) {
    instant.wrenches.erase(instant.wrenches.begin());
  }
  const auto solid = elasticity::solve<3>(
      {problem.mesh, problem.material, history, fixed, "eye"}, 4);
  const auto layered = elasticity::solve_layered(
      {eye.plate, problem.material, history, fixed, "eye"}, 4, 4);
  for (Index i = 0; i < 2; ++i) {
    EXPECT_NEAR(layered.strain_energy[i] / solid.strain_energy[i], 1.0, 2e-3);
  }
}

}  // namespace
}  // namespace clevis
