// Vibration of a free part under its load history: a bar pushed at one end
// against the wave in it. Source: docs/theory.md, "Vibration under a load
// history".

#include "elasticity/vibration/load_vibration.h"

#include <cmath>

#include <gtest/gtest.h>

#include "dynamics/load_vibration/load_answer.h"
#include "stress/field/stress_history.h"
#include "stress/zones/zone_mask.h"
#include "support/eye_problem.h"
#include "support/structured_mesh.h"

namespace clevis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// No lateral contraction: waves along the bar keep their shape.
const part::Material kCork{"cork", 70e9, 0.0, 2700.0, 200e6};
const Vector3d kSize(0.3, 0.02, 0.01);
constexpr double kPull = 40e6;  // [Pa]

template <int dim>
mesh::PartMesh<dim> bar() {
  using Point = Eigen::Matrix<double, dim, 1>;
  std::array<int, dim> divisions{};
  divisions.fill(1);
  divisions[0] = 20;
  auto mesh =
      support::structured_mesh<dim>(divisions, 1, [](const Point& x) -> Point {
        Point p = x.cwiseProduct(kSize.head<dim>());
        for (int d = 1; d < dim; ++d) p[d] -= 0.5 * kSize[d];
        return p;
      });
  if (dim == 2) mesh.thickness = kSize.z();
  return mesh;
}

/// The end x = L pulled by a share of kPull, the bar accelerating as a whole.
loads::InstantLoad pulled(double time, double share) {
  loads::InstantLoad instant;
  instant.time = time;
  instant.rigid.acceleration.x() = share * kPull / (kCork.density * kSize.x());
  loads::SurfaceLoad load;
  load.group = "x1";
  load.traction.x() = share * kPull;
  load.resultant.force.x() = share * kPull * kSize.y() * kSize.z();
  instant.surface_loads.push_back(load);
  return instant;
}

/// Stress at x under a pull that rises evenly in `rise` and stays: what comes
/// from the pulled end straight and over the free ends.
double wave(double x, double t, double rise) {
  const double speed = std::sqrt(kCork.youngs_modulus / kCork.density);
  const double length = kSize.x();
  double stress = 0.0;
  for (int k = 0; k < 20; ++k) {
    const double way = (2 * k + 1) * length;
    stress += std::clamp((t - (way - x) / speed) / rise, 0.0, 1.0) -
              std::clamp((t - (way + x) / speed) / rise, 0.0, 1.0);
  }
  return kPull * stress;
}

template <int dim>
void expect_wave(int shapes, double tolerance) {
  const auto mesh = bar<dim>();
  const double transit =
      kSize.x() * std::sqrt(kCork.density / kCork.youngs_modulus);
  const double rise = 0.5 * transit, end = 6.0 * transit;
  loads::LoadHistory history;
  for (const auto& [t, share] : std::vector<std::pair<double, double>>{
           {0.0, 0.0}, {0.0, 0.0}, {rise, 1.0}, {rise, 1.0}, {end, 1.0}}) {
    history.instants.push_back(pulled(t, share));
  }
  const auto rest =
      elasticity::part_at_rest<dim>({mesh, kCork, history, {}, "bar"}, 3);
  elasticity::LoadVibration<dim> part(rest, history, "bar", {2}, {2});
  EXPECT_EQ(part.driving_loads(), 1);
  const auto found = part.shapes(shapes);
  VectorXd time(5);
  for (Index i = 0; i < 5; ++i) {
    time[i] = history.instants[static_cast<std::size_t>(i)].time;
  }
  const dynamics::LoadPath path(time, rest.statics.coefficients,
                                1e-9 * transit);
  const auto answer = dynamics::answer_to(
      path, found.participation, found.squares,
      dynamics::ModeDamping::even(0.0, found.squares.size()),
      VectorXd::LinSpaced(301, 0.0, end));
  elasticity::DisplacementBasis<dim> all;
  all.discretization = rest.statics.discretization;
  all.columns.resize(found.columns.rows(),
                     rest.statics.columns.cols() + found.columns.cols());
  all.columns << rest.statics.columns, found.columns;
  all.coefficients.resize(all.columns.cols(), answer.time.size());
  all.coefficients << answer.path, answer.added;
  // The middle of the bar: the first corner of the eleventh cell.
  const VectorXd stress = stress::point_history<dim>(all, kCork, {10, 0}, 1);
  double largest = 0.0;
  for (Index i = 0; i < stress.size(); ++i) {
    EXPECT_NEAR(stress[i],
                std::abs(wave(0.5 * kSize.x(), answer.time[i], rise)),
                tolerance * kPull)
        << answer.time[i] / transit;
    largest = std::max(largest, stress[i]);
  }
  // Half of the pull at rest in the accelerated bar, all of it in the wave.
  EXPECT_NEAR(largest, kPull, tolerance * kPull);
  const VectorXd still =
      stress::point_history<dim>(rest.statics, kCork, {10, 0}, 1);
  EXPECT_NEAR(still[4], 0.5 * kPull, 1e-9 * kPull);
}

TEST(LoadVibration, WaveInAFreePlate) {
  expect_wave<2>(60, 0.02);
}

TEST(LoadVibration, WaveInAFreeSolid) {
  expect_wave<3>(60, 0.02);
}

// A bore whose pin takes force and moments. Shapes held in its mean motions
// undo the answer at rest where all begin: with it the pin's own pressure, not
// a linear traction of the same resultant.
TEST(LoadVibration, APinPressesOnAsAtRest) {
  auto eye = support::eye_problem(1);
  // Cells between rim and bore: one alone joins the inertia of both.
  eye.mesh = support::ring_mesh<3>({.inner = 0.01,
                                    .outer = 0.02,
                                    .thickness = 0.008,
                                    .radial = 4,
                                    .angular = 8,
                                    .axial = 1,
                                    .degree = 2});
  eye.history.instants[0].wrenches[0].moment = {12.0, -7.0, 3.0};
  eye.history.instants[0].wrenches[1].moment = {-12.0, 7.0, -3.0};
  // Forces press as the hold does: a bore that is turned alone.
  for (auto& wrench : eye.history.instants[0].wrenches) {
    wrench.force.setZero();
  }
  eye.history.instants[0].rigid.acceleration.setZero();
  eye.history.hold = [](double) {
    loads::SeatHold hold;
    hold.held = MatrixXd::Identity(12, 6);
    hold.weighed = MatrixXd(12, 0);
    return hold;
  };
  const auto rest = elasticity::part_at_rest<3>(eye.problem(), 3);
  elasticity::LoadVibration<3> part(rest, eye.history, "eye", {0}, {0});
  const auto found = part.shapes(80);
  auto left = rest.statics;
  const VectorXd undone = found.participation * rest.statics.coefficients;
  left.columns.conservativeResize(Eigen::NoChange, 1 + undone.size());
  left.columns.col(0) = rest.statics.columns * rest.statics.coefficients;
  left.columns.rightCols(undone.size()) = found.columns;
  left.coefficients.resize(1 + undone.size(), 1);
  left.coefficients << VectorXd::Ones(1), -undone;
  const auto largest = [&](const elasticity::DisplacementBasis<3>& basis,
                           double radius) {
    const auto worst = stress::stress_history<3>(basis, eye.material, 2).worst;
    double most = 0.0;
    for (Index c = 0; c < worst.cols(); ++c) {
      for (Index q = 0; q < worst.rows(); ++q) {
        const Vector3d at =
            stress::position<3>(basis.discretization,
                                {static_cast<int>(c), static_cast<int>(q)}, 2);
        if (std::abs(at.head<2>().norm() - radius) < 1e-4) {
          most = std::max(most, worst(q, c));
        }
      }
    }
    return most;
  };
  EXPECT_LT(largest(left, 0.01), 0.005 * largest(rest.statics, 0.01));
}

}  // namespace
}  // namespace clevis
