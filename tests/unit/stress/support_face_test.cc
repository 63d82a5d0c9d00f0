// What a support does to a part, against balance and beam theory.

#include "stress/sections/support_face.h"

#include <cmath>
#include <functional>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "elasticity/solid/solid_solve.h"
#include "part/supports.h"
#include "support/annulus_mesh.h"
#include "support/structured_mesh.h"

namespace clevis::stress {
namespace {

using Eigen::Vector3d;

const part::Material kSteel{"steel", 210e9, 0.3, 7850.0, 355e6};
const Vector3d kSize(0.2, 0.012, 0.02);
const Vector3d kTip(kSize.x(), 0.0, 0.0);

/// Along x about its own axis.
mesh::PartMesh<3> bar(int cells = 4, int degree = 1) {
  return support::structured_mesh<3>(
      {cells, 1, 2}, degree, [](const Vector3d& x) -> Vector3d {
        return kSize.cwiseProduct(x - Vector3d(0.0, 0.5, 0.5));
      });
}

/// By a force and a moment about the middle of a side, spread over it.
std::vector<SupportFace> held_by(const mesh::PartMesh<3>& mesh,
                                 const std::string& side, const Vector3d& at,
                                 const std::vector<loads::Wrench>& loads,
                                 const part::Supports& fixed, int degree,
                                 const part::Material& material = kSteel) {
  loads::LoadHistory history;
  history.seats = {{"side", side, loads::SeatKind::kTraction, at}};
  for (const auto& load : loads) {
    loads::InstantLoad instant;
    instant.wrenches = {load};
    history.instants.push_back(instant);
  }
  const auto basis =
      elasticity::solve<3>({mesh, material, history, fixed, "bar"}, degree);
  return support_faces<3>(basis, material, fixed, history, "bar");
}

// However coarse, and beside an edge without bound: the support's force and
// moment balance the load, and make M y / I about both axes.
TEST(SupportFace, BalancesTheLoadOfACantilever) {
  const loads::Wrench bends{{300.0, -70.0, 40.0}, {0.0, 2.0, -1.0}};
  const loads::Wrench twists{Vector3d::Zero(), {5.0, 0.0, 0.0}};
  for (const int degree : {1, 2, 3}) {
    const auto faces = held_by(bar(), "x1", kTip, {bends, twists},
                               {{"x0", {true, true, true}}}, degree);
    ASSERT_EQ(faces.size(), 1U);
    const SupportFace& face = faces[0];
    EXPECT_EQ(face.name, "x0");
    const Vector3d moment = bends.moment + kTip.cross(bends.force);
    EXPECT_LT((face.force.col(0) + bends.force).norm(), 1e-8 * 300.0);
    EXPECT_LT((face.moment.col(0) + moment).norm(), 1e-8 * moment.norm());
    EXPECT_LT((face.moment.col(1) + twists.moment).norm(), 1e-8 * 5.0);
    const double area = kSize.y() * kSize.z();
    const double bent = bends.force.x() / area +
                        6.0 * std::abs(moment.z()) / (area * kSize.y()) +
                        6.0 * std::abs(moment.y()) / (area * kSize.z());
    EXPECT_NEAR(face.nominal[0], bent, 1e-8 * bent);
    const double square = kSize.y() * kSize.y() + kSize.z() * kSize.z();
    const double polar = area * square / 12.0;
    const double twisted =
        std::sqrt(3.0) * 5.0 / polar * std::sqrt(square) / 2.0;
    EXPECT_NEAR(face.nominal[1], twisted, 1e-8 * twisted);
  }
}

// Where nothing bends the face, its mean shear counts.
TEST(SupportFace, KnowsMeanShear) {
  constexpr double kForce = 1000.0;
  const auto faces =
      held_by(bar(), "x1", kTip,
              {{{0.0, kForce, 0.0}, {0.0, 0.0, -kForce * kSize.x()}}},
              {{"x0", {true, true, true}}}, 2);
  const double mean = std::sqrt(3.0) * kForce / (kSize.y() * kSize.z());
  EXPECT_NEAR(faces[0].nominal[0], mean, 1e-8 * mean);
}

// Clamped at one end, the other may only slide across: F L / 2 at both where
// no Poisson ratio tells a clamp from a guide.
TEST(SupportFace, BothEndsOfAGuidedBar) {
  constexpr double kForce = 100.0;
  const auto faces =
      held_by(bar(8), "x1", kTip, {{{0.0, kForce, 0.0}, Vector3d::Zero()}},
              {{"x0", {true, true, true}}, {"x1", {true, false, true}}}, 3,
              {"cork", 70e9, 0.0, 2700.0, 200e6});
  ASSERT_EQ(faces.size(), 2U);
  const double moment = kForce * kSize.x() / 2.0;
  for (const SupportFace& face : faces) {
    EXPECT_NEAR(std::abs(face.moment(2, 0)), moment, 1e-3 * moment);
    EXPECT_NEAR(face.nominal[0],
                6.0 * moment / (kSize.z() * kSize.y() * kSize.y()),
                1e-3 * face.nominal[0]);
  }
}

/// Puts faces of a cell into a group of their own, once more.
void regroup(mesh::PartMesh<3>& mesh, const std::string& from,
             const std::string& to,
             const std::function<bool(const Vector3d& centre)>& where) {
  const auto group = [&](const std::string& name) {
    for (std::size_t g = 0; g < mesh.groups.size(); ++g) {
      if (mesh.groups[g].name == name) return static_cast<int>(g);
    }
    mesh.groups.push_back({name, {}});
    return static_cast<int>(mesh.groups.size()) - 1;
  };
  const int old = group(from), renamed = group(to);
  for (auto& face : mesh.boundary) {
    const auto& points = mesh.cell_points[static_cast<std::size_t>(face.cell)];
    if (face.group == old && where(points.rowwise().mean())) {
      face.group = renamed;
    }
  }
}

// Names do not matter: a face in two groups is one section, two feet in one
// group are two.
TEST(SupportFace, IsAConnectedPlanePiece) {
  auto split = bar();
  regroup(split, "x0", "upper", [](const Vector3d& p) {
    return p.z() > 0.0;
  });
  const loads::Wrench bends{{300.0, -70.0, 40.0}, {0.0, 2.0, -1.0}};
  const part::Supports both{{"x0", {true, true, true}},
                            {"upper", {true, true, true}}};
  const auto whole =
      held_by(bar(), "x1", kTip, {bends}, {{"x0", {true, true, true}}}, 2);
  const auto halves = held_by(split, "x1", kTip, {bends}, both, 2);
  ASSERT_EQ(halves.size(), 1U);
  EXPECT_EQ(halves[0].name, "upper + x0");
  EXPECT_NEAR(halves[0].nominal[0], whole[0].nominal[0],
              1e-9 * whole[0].nominal[0]);

  auto feet = support::structured_mesh<3>(
      {1, 1, 3}, 1, [](const Vector3d& x) -> Vector3d {
        return kSize.cwiseProduct(x - Vector3d(0.0, 0.5, 0.5));
      });
  regroup(feet, "x0", "between", [](const Vector3d& p) {
    return std::abs(p.z()) < 1e-3;
  });
  const auto pads =
      held_by(feet, "x1", kTip, {bends}, {{"x0", {true, true, true}}}, 2);
  ASSERT_EQ(pads.size(), 2U);
  EXPECT_LT((pads[0].force + pads[1].force + bends.force).norm(), 1e-7 * 300.0);
  EXPECT_EQ(pads[0].name.substr(0, 6), "x0 at ");
  EXPECT_NE(pads[0].name, pads[1].name);
}

// Loads that the held nodes share: their part goes straight into the support.
TEST(SupportFace, HasTheLoadsOfItsOwnNodes) {
  loads::LoadHistory history;
  loads::InstantLoad whirls;
  whirls.rigid.acceleration = Vector3d(2e5, 0.0, 0.0);
  history.instants = {whirls};
  const part::Supports fixed{{"x0", {true, true, true}}};
  const auto mesh = bar(1);
  const auto basis =
      elasticity::solve<3>({mesh, kSteel, history, fixed, "bar"}, 1);
  const auto faces = support_faces<3>(basis, kSteel, fixed, history, "bar");
  const double pulled = 7850.0 * kSize.x() * 2e5;
  EXPECT_NEAR(faces[0].nominal[0], pulled, 1e-8 * pulled);
}

// The outermost fibre of a round face lies between its nodes.
TEST(SupportFace, OfARoundBarInAnyDirection) {
  support::Annulus ring;
  ring.inner = 0.004;
  ring.outer = 0.01;
  ring.thickness = 0.05;
  ring.radial = 1;
  ring.angular = 16;
  ring.axial = 2;
  ring.degree = 3;
  const double inertia = 0.25 * 3.14159265358979 *
                         (std::pow(ring.outer, 4) - std::pow(ring.inner, 4));
  for (const double angle : {0.0, 0.1, 0.2, 0.3, 0.3927}) {
    const Vector3d force(100.0 * std::cos(angle), 100.0 * std::sin(angle), 0.0);
    const auto faces =
        held_by(support::ring_mesh<3>(ring), "z1", {0.0, 0.0, ring.thickness},
                {{force, Vector3d::Zero()}}, {{"z0", {true, true, true}}}, 2);
    ASSERT_EQ(faces.size(), 1U);
    const double bent = 100.0 * ring.thickness * ring.outer / inertia;
    EXPECT_NEAR(faces[0].nominal[0], bent, 1e-3 * bent) << angle;
  }
}

TEST(SupportFace, OfAPlateInItsPlane) {
  auto plate = support::structured_mesh<2>(
      {6, 2}, 1, [](const Eigen::Vector2d& x) -> Eigen::Vector2d {
        return {kSize.x() * x.x(), kSize.y() * (x.y() - 0.5)};
      });
  plate.thickness = kSize.z();
  loads::LoadHistory history;
  history.seats = {{"side", "x1", loads::SeatKind::kTraction, kTip}};
  history.instants.resize(1);
  history.instants[0].wrenches = {{{200.0, -50.0, 0.0}, Vector3d::Zero()}};
  const part::Supports fixed{{"x0", {true, true, true}}};
  const auto basis =
      elasticity::solve<2>({plate, kSteel, history, fixed, "plate"}, 2);
  const auto faces = support_faces<2>(basis, kSteel, fixed, history, "plate");
  ASSERT_EQ(faces.size(), 1U);
  const double area = kSize.y() * kSize.z();
  EXPECT_NEAR(faces[0].moment(2, 0), 50.0 * kSize.x(), 1e-8 * 10.0);
  const double bent = 200.0 / area + 6.0 * 10.0 / (area * kSize.y());
  EXPECT_NEAR(faces[0].nominal[0], bent, 1e-8 * bent);
}

TEST(SupportFace, IsPlane) {
  support::Annulus ring;
  ring.inner = 0.01;
  ring.outer = 0.02;
  ring.thickness = 0.008;
  ring.radial = 1;
  ring.angular = 8;
  ring.axial = 1;
  ring.degree = 2;
  const auto faces = held_by(
      support::ring_mesh<3>(ring), "x1", {0.0, 0.0, 0.004},
      {{{100.0, 0.0, 0.0}, Vector3d::Zero()}}, {{"x0", {true, true, true}}}, 2);
  EXPECT_TRUE(faces.empty());
}

}  // namespace
}  // namespace clevis::stress
