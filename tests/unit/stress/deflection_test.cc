#include "stress/displacement/deflection.h"

#include <cmath>

#include <gtest/gtest.h>

#include "elasticity/assembly/supports.h"
#include "elasticity/holds/pin_hold.h"
#include "elasticity/solid/solid_solve.h"
#include "stress/displacement/held_reference.h"
#include "stress/field/stress_history.h"
#include "support/eye_problem.h"

namespace clevis::stress {
namespace {

using Eigen::Vector3d;

const part::Material kCork{"cork", 70e9, 0.0, 2700.0, 200e6};
const Vector3d kSize(0.2, 0.01, 0.02);

mesh::PartMesh<3> bar_mesh() {
  return support::structured_mesh<3>({4, 1, 1}, 1,
                                     [](const Vector3d& x) -> Vector3d {
                                       return kSize.cwiseProduct(x);
                                     });
}

// A bush: both seats about one centre, between which there is no line.
TEST(Deflection, ConcentricSeats) {
  const auto eye = support::eye_problem(2);
  const auto solved = elasticity::solve<3>(eye.problem(), 2);
  auto basis = solved;
  remove_rigid_motion<3>(basis, {{"x0", "x1"}});
  const auto peak = [&](const elasticity::DisplacementBasis<3>& of) {
    return stress_history<3>(of, eye.material, 2).largest();
  };
  EXPECT_NEAR(peak(basis) / peak(solved), 1.0, 1e-9);
  auto by_first = solved;
  remove_rigid_motion<3>(by_first, {{"x0"}});
  EXPECT_NEAR(largest_deflection<3>(basis).value /
                  largest_deflection<3>(by_first).value,
              1.0, 1e-12);
}

TEST(Deflection, RigidMotionIsRemovedExactly) {
  const auto eye = support::eye_problem(2);
  auto basis = elasticity::solve<3>(eye.problem(), 2);
  auto moved = basis;
  const auto positions = elasticity::node_positions(basis.discretization);
  const Eigen::MatrixXd modes =
      elasticity::rigid_modes<3>(positions, Vector3d(0.1, 0.0, -0.2), 1.0);
  Eigen::MatrixXd amounts(6, basis.columns.cols());
  for (Eigen::Index k = 0; k < amounts.size(); ++k) {
    amounts(k % 6, k / 6) = basis.columns.cwiseAbs().maxCoeff() *
                            std::sin(3.0 * static_cast<double>(k) + 1.0);
  }
  moved.columns += modes * amounts;
  for (const auto& seats :
       {std::vector<std::string>{"x0"}, std::vector<std::string>{"x0", "z1"}}) {
    auto first = basis;
    auto second = moved;
    remove_rigid_motion<3>(first, {seats});
    remove_rigid_motion<3>(second, {seats});
    EXPECT_LT((first.columns - second.columns).cwiseAbs().maxCoeff(),
              1e-12 * first.columns.cwiseAbs().maxCoeff());
  }
}

TEST(Deflection, BarInTensionElongates) {
  const double pull = 30e6;
  const auto mesh = bar_mesh();
  loads::LoadHistory history;
  history.instants.push_back({});
  for (const char* side : {"x0", "x1"}) {
    loads::SurfaceLoad load;
    load.group = side;
    const bool far = load.group == "x1";
    load.traction.x() = far ? pull : -pull;
    load.resultant.force = kSize.y() * kSize.z() * load.traction;
    load.resultant.moment =
        Vector3d(far ? kSize.x() : 0.0, kSize.y() / 2, kSize.z() / 2)
            .cross(load.resultant.force);
    history.instants[0].surface_loads.push_back(load);
  }
  auto basis = elasticity::solve<3>({mesh, kCork, history, {}, "bar"}, 2);
  remove_rigid_motion<3>(basis, {{"x0", "x1"}});
  const auto deflection = largest_deflection<3>(basis);
  EXPECT_NEAR(deflection.value / (pull * kSize.x() / kCork.youngs_modulus), 1.0,
              1e-9);
  EXPECT_NEAR(deflection.at.x(), kSize.x(), 1e-12);
  EXPECT_EQ(deflection.instant, 0);
}

// Held across by springs of k at x0 and c k at x1: what the ends move, weighed
// by the stiffness, is no rigid motion.
TEST(Deflection, SpringsHoldByTheirStiffness) {
  const auto eye = support::eye_problem(2);
  const auto solved = elasticity::solve<3>(eye.problem(), 2);
  elasticity::MeanMotions<3> motions(solved.discretization);
  const auto spring = [&](const char* group, double stiffness, Eigen::Index k) {
    loads::GroupHold hold{group, motions.of_group(group).centre,
                          Eigen::MatrixXd::Zero(6, 2)};
    hold.wrenches(0, k) = std::sqrt(stiffness);
    return hold;
  };
  const auto mean_at = [&](const char* group, const Eigen::MatrixXd& u) {
    return Eigen::RowVectorXd(motions.of_group(group).of.of(u).row(0));
  };
  for (const double ratio : {1.0, 100.0}) {
    elasticity::HoldingSeats hold{.groups = {"x0"}};
    hold.sprung = {spring("x0", 1e6, 0), spring("x1", ratio * 1e6, 1)};
    const elasticity::PinHold<3> alone(motions, hold);
    const Eigen::MatrixXd u = alone.project(solved.columns);
    const Eigen::RowVectorXd rest = mean_at("x0", u) + ratio * mean_at("x1", u);
    EXPECT_LT(rest.norm(), 1e-9 * ratio * mean_at("x1", solved.columns).norm());
    // Where a joint holds the end, its spring has no say.
    hold.held = {spring("x0", 1.0, 0)};
    hold.held[0].wrenches.conservativeResize(6, 1);
    const elasticity::PinHold<3> joined(motions, hold);
    const Eigen::MatrixXd held = joined.project(solved.columns);
    EXPECT_LT(mean_at("x0", held).norm(), 1e-9 * held.norm());
  }
}

// Tip shear on a fixed bar: F L³/(3 E I) and the shear of Timoshenko's beam,
// 6/5 F L/(G A).
TEST(Deflection, Cantilever) {
  const double shear = 1e6;
  const auto mesh = bar_mesh();
  loads::LoadHistory history;
  history.instants.resize(2);
  for (int i = 0; i < 2; ++i) {
    loads::SurfaceLoad load;
    load.group = "x1";
    load.traction.y() = shear * (i + 1);
    load.resultant.force = kSize.y() * kSize.z() * load.traction;
    load.resultant.moment = Vector3d(kSize.x(), kSize.y() / 2, kSize.z() / 2)
                                .cross(load.resultant.force);
    history.instants[static_cast<std::size_t>(i)].surface_loads.push_back(load);
  }
  const auto basis = elasticity::solve<3>(
      {mesh, kCork, history, {{"x0", {true, true, true}}}, "bar"}, 3);
  const double area = kSize.y() * kSize.z();
  const double force = 2 * shear * area;
  const double inertia = area * kSize.y() * kSize.y() / 12;
  const double expected =
      force * std::pow(kSize.x(), 3) / (3 * kCork.youngs_modulus * inertia) +
      1.2 * force * kSize.x() / (0.5 * kCork.youngs_modulus * area);
  const auto deflection = largest_deflection<3>(basis);
  EXPECT_NEAR(deflection.value / expected, 1.0, 3e-3);
  EXPECT_NEAR(deflection.at.x(), kSize.x(), 1e-12);
  EXPECT_EQ(deflection.instant, 1);
}

TEST(VonMises, ClosedForms) {
  Eigen::MatrixXd stress(5, 6);
  stress << 80, 0, 0, 0, 0, 0,  // uniaxial
      0, 0, 0, 0, 50, 0,        // pure shear
      -30, -30, -30, 0, 0, 0,   // hydrostatic
      60, 60, 0, 0, 0, 0,       // equibiaxial
      10, 20, 30, 4, 5, 6;
  const Eigen::VectorXd equivalent = von_mises(stress);
  EXPECT_DOUBLE_EQ(equivalent[0], 80.0);
  EXPECT_DOUBLE_EQ(equivalent[1], 50.0 * std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(equivalent[2], 0.0);
  EXPECT_DOUBLE_EQ(equivalent[3], 60.0);
  EXPECT_DOUBLE_EQ(equivalent[4], std::sqrt(300.0 + 3 * (16 + 25 + 36)));
}

// Stretched evenly, a plate thins: its surface sinks by half of that.
TEST(Deflection, SurfaceOfAPlateMovesAcrossIt) {
  constexpr double kStrain = 1e-3;
  const part::Material steel{"steel", 210e9, 0.3, 7850.0, 355e6};
  auto mesh = support::structured_mesh<2>(
      {3, 2}, 1, [](const Eigen::Vector2d& x) -> Eigen::Vector2d {
        return {0.05 * x[0] + 0.01 * x[1], 0.04 * x[1]};
      });
  mesh.thickness = 0.1;
  mesh.mid_plane_z = 0.02;
  elasticity::DisplacementBasis<2> basis;
  basis.discretization = elasticity::discretize<2>(mesh, 2);
  const auto at = elasticity::node_positions(basis.discretization);
  basis.columns.resize(basis.discretization.dofs(), 1);
  for (Eigen::Index i = 0; i < at.cols(); ++i) {
    basis.columns.middleRows<2>(2 * i) << kStrain * at(0, i),
        -0.3 * kStrain * at(1, i);
  }
  basis.coefficients = Eigen::RowVector2d(-0.5, 2.0);
  const auto found = largest_deflection_of_plate(basis, steel);
  const Vector3d corner(0.06, 0.04, 0.02 + 0.05);
  EXPECT_LT((found.at - corner).norm(), 1e-12);
  EXPECT_EQ(found.instant, 1);
  const double farthest =
      kStrain * Vector3d(0.06, -0.3 * 0.04, -0.3 * 0.05).norm();
  EXPECT_NEAR(found.value, 2.0 * farthest, 1e-12 * farthest);
  EXPECT_NEAR(found.of_instant[0], 0.5 * farthest, 1e-12 * farthest);
}

// Stress that grows without bound towards a corner moves no surface there: the
// means over half a thickness are those of any mesh that is finer.
TEST(Deflection, ACornerDoesNotMoveAPlateAcrossIt) {
  constexpr double kSide = 0.04, kThickness = 0.02, kStrain = 1e-3;
  const part::Material steel{"steel", 210e9, 0.3, 7850.0, 355e6};
  const auto deflection = [&](double fineness) {
    // cells that fall towards the corner at the origin
    auto mesh = support::structured_mesh<2>(
        {24, 24}, 1, [&](const Eigen::Vector2d& x) -> Eigen::Vector2d {
          return kSide * Eigen::Vector2d(std::pow(x[0], fineness),
                                         std::pow(x[1], fineness));
        });
    mesh.thickness = kThickness;
    elasticity::DisplacementBasis<2> basis;
    basis.discretization = elasticity::discretize<2>(mesh, 2);
    const auto at = elasticity::node_positions(basis.discretization);
    basis.columns.resize(basis.discretization.dofs(), 1);
    for (Eigen::Index i = 0; i < at.cols(); ++i) {  // strain ~ r^-0.4
      const double r = at.col(i).norm() / kSide;
      basis.columns.middleRows<2>(2 * i) =
          kStrain * at.col(i) * (r > 0.0 ? std::pow(r, -0.4) : 0.0);
    }
    basis.coefficients = Eigen::MatrixXd::Ones(1, 1);
    return largest_deflection_of_plate(basis, steel).value;
  };
  const double coarse = deflection(1.5);
  EXPECT_NEAR(deflection(4.0), coarse, 0.01 * coarse);
}

// A bar that swings about its middle beside one that stretches: the farthest
// end at the farthest time, between the times that are looked at first.
TEST(Deflection, LargestOfManyInstants) {
  const auto mesh = bar_mesh();
  elasticity::DisplacementBasis<3> basis;
  basis.discretization = elasticity::discretize<3>(mesh, 1);
  const auto at = elasticity::node_positions(basis.discretization);
  basis.columns = Eigen::MatrixXd::Zero(basis.discretization.dofs(), 2);
  for (Eigen::Index i = 0; i < at.cols(); ++i) {
    basis.columns(3 * i + 1, 0) = at(0, i) - 0.5 * kSize.x();
    basis.columns(3 * i, 1) = at(0, i);
  }
  constexpr int kInstants = 1000;
  basis.coefficients.resize(2, kInstants);
  for (int i = 0; i < kInstants; ++i) {
    basis.coefficients.col(i) << 2e-3 * std::sin(0.0314 * (i - 451)),
        1e-3 * std::cos(0.0314 * (i - 451));
  }
  const auto all = largest_deflection<3>(basis);
  ASSERT_NE(all.instant % 6, 0);
  EXPECT_EQ(largest_deflection_of_many<3>(basis, 6), all.value);
}

}  // namespace
}  // namespace clevis::stress
