// Blocks with polynomial solutions: what any conforming element of sufficient
// degree must reproduce to round-off.

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "elasticity/problem/displacement_basis.h"
#include "elasticity/solid/solid_solve.h"
#include "stress/field/stress_history.h"
#include "support/structured_mesh.h"

namespace clevis {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

const part::Material kSteel{"steel", 210e9, 0.3, 7850.0, 355e6};

/// A box a × b × c whose inner nodes are pushed about: distorted hexes.
mesh::PartMesh<3> distorted_box(const Vector3d& size, double distortion) {
  return support::structured_mesh<3>(
      {3, 2, 2}, 1, [=](const Vector3d& x) -> Vector3d {
        const double bubble =
            64.0 * x[0] * (1 - x[0]) * x[1] * (1 - x[1]) * x[2] * (1 - x[2]);
        const Vector3d push(std::sin(7 * x[1]), std::cos(5 * x[2]),
                            std::sin(3 * x[0]));
        return size.cwiseProduct(x + distortion * bubble * push);
      });
}

loads::InstantLoad surface_tractions(
    const std::vector<std::pair<std::string, Vector3d>>& tractions,
    const std::vector<double>& areas, const std::vector<Vector3d>& centres) {
  loads::InstantLoad instant;
  instant.label = "case";
  for (std::size_t k = 0; k < tractions.size(); ++k) {
    loads::SurfaceLoad load;
    load.group = tractions[k].first;
    load.traction = tractions[k].second;
    load.resultant.force = areas[k] * tractions[k].second;
    load.resultant.moment = centres[k].cross(load.resultant.force);
    instant.surface_loads.push_back(load);
  }
  return instant;
}

// Uniform stress on distorted hexes, all six components at once.
TEST(Block, PatchTestOnDistortedHexes) {
  const Vector3d size(0.03, 0.02, 0.01);
  const auto mesh = distorted_box(size, 0.15);
  Eigen::Matrix3d stress;
  stress << 80e6, 20e6, -10e6, 20e6, -30e6, 15e6, -10e6, 15e6, 50e6;
  std::vector<std::pair<std::string, Vector3d>> tractions;
  std::vector<double> areas;
  std::vector<Vector3d> centres;
  const char* const names[] = {"x0", "x1", "y0", "y1", "z0", "z1"};
  for (int side = 0; side < 6; ++side) {
    const Vector3d normal =
        (side % 2 == 0 ? -1.0 : 1.0) * Vector3d::Unit(side / 2);
    Vector3d centre = 0.5 * size;
    centre[side / 2] = side % 2 == 0 ? 0.0 : size[side / 2];
    tractions.emplace_back(names[side], stress * normal);
    areas.push_back(size.prod() / size[side / 2]);
    centres.push_back(centre);
  }
  loads::LoadHistory history;
  history.instants.push_back(surface_tractions(tractions, areas, centres));
  for (int degree = 1; degree <= 4; ++degree) {
    const auto basis =
        elasticity::solve<3>({mesh, kSteel, history, {}, "box"}, degree);
    const auto field = stress::instant_field<3>(basis, kSteel, 2, 0);
    for (const auto& cell : field.stress) {
      for (Eigen::Index q = 0; q < cell.rows(); ++q) {
        Eigen::Matrix<double, 1, 6> exact;
        exact << stress(0, 0), stress(1, 1), stress(2, 2), stress(0, 1),
            stress(1, 2), stress(0, 2);
        // Round-off times the condition of a stiffness matrix of this size.
        EXPECT_LT((cell.row(q) - exact).cwiseAbs().maxCoeff(), 1e-9 * 80e6)
            << "degree " << degree;
      }
    }
  }
}

// Prism in pure bending: u is a polynomial of degree 2, exact in 3-D with
// anticlastic curvature. Ends take sigma_xx = k (y − b/2).
TEST(Block, PureBendingIsExactWithDegreeTwo) {
  const Vector3d size(0.06, 0.01, 0.02);
  const auto mesh = support::structured_mesh<3>(
      {2, 1, 1}, 1, [&](const Vector3d& x) -> Vector3d {
        return size.cwiseProduct(x);
      });
  // A seat of linear traction on the end faces carries a pure moment.
  loads::LoadHistory history;
  loads::InstantLoad instant;
  const double moment = 25.0;
  for (const auto& [name, side] : {std::pair{"x0", -1.0}, {"x1", 1.0}}) {
    loads::Seat seat;
    seat.name = seat.group = name;
    seat.kind = loads::SeatKind::kTraction;
    seat.p_LS = Vector3d(side < 0 ? 0.0 : size[0], size[1] / 2, size[2] / 2);
    history.seats.push_back(seat);
    instant.wrenches.push_back(
        {Vector3d::Zero(), side * Vector3d(0, 0, moment)});
  }
  history.instants.push_back(instant);
  const double inertia = size[2] * std::pow(size[1], 3) / 12.0;
  // On an end face θ × (p − c) = −θ (y − b/2) e_x: the beam's own stress.
  const auto basis =
      elasticity::solve<3>({mesh, kSteel, history, {}, "bar"}, 2);
  EXPECT_LT(basis.checks.residual, 1e-11);
  const auto field = stress::instant_field<3>(basis, kSteel, 2, 0);
  const double peak = moment * size[1] / 2 / inertia;
  for (std::size_t c = 0; c < field.points.size(); ++c) {
    for (Eigen::Index q = 0; q < field.points[c].rows(); ++q) {
      const double exact =
          -moment * (field.points[c](q, 1) - size[1] / 2) / inertia;
      EXPECT_NEAR(field.stress[c](q, 0), exact, 1e-12 * peak);
      EXPECT_NEAR(field.stress[c](q, 1), 0.0, 1e-12 * peak);
      EXPECT_NEAR(field.stress[c](q, 3), 0.0, 1e-12 * peak);
    }
  }
}

}  // namespace
}  // namespace clevis
