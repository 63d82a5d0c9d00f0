#include "calculix/model.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "unit/calculix/cube.h"

namespace clevis::calculix {
namespace {

using Eigen::Vector3d;

const Group& group(const Model& model, const std::string& name) {
  for (const auto& g : model.groups) {
    if (g.name == name) return g;
  }
  throw std::runtime_error("no group " + name);
}

bool is_corner(const Vector3d& at) {
  return (at.array() * (1.0 - at.array())).abs().maxCoeff() < 1e-12;
}

TEST(CalculixModel, CubeHasTheNodesOfTwentyNodeHexahedra) {
  const Model model = pressed_cube(2, 1e6);
  EXPECT_EQ(model.element, "C3D20");
  EXPECT_EQ(model.elements.size(), 8U);
  EXPECT_EQ(model.nodes.cols(), 27 + 54);  // vertices and edges of 2 x 2 x 2
  EXPECT_EQ(group(model, "x1").nodes.size(), 9U + 12U);
  EXPECT_EQ(group(model, "x1").faces.size(), 4U);
}

// Corners 1-8, then the middles of 1-2, 2-3, 3-4, 4-1, 5-6 …, 1-5 …
TEST(CalculixModel, ElementNodesStandInCalculixOrder) {
  const Model model = pressed_cube(1, 1e6);
  const auto at = [&](int k) -> Vector3d {
    return model.nodes.col(model.elements[0][static_cast<std::size_t>(k - 1)]);
  };
  const Vector3d x = at(2) - at(1), y = at(4) - at(1), z = at(5) - at(1);
  EXPECT_GT(x.cross(y).dot(z), 0.99);  // right-handed
  const int edges[12][3] = {{1, 2, 9},  {2, 3, 10}, {3, 4, 11}, {4, 1, 12},
                            {5, 6, 13}, {6, 7, 14}, {7, 8, 15}, {8, 5, 16},
                            {1, 5, 17}, {2, 6, 18}, {3, 7, 19}, {4, 8, 20}};
  for (const auto& [a, b, middle] : edges) {
    EXPECT_LT((at(middle) - 0.5 * (at(a) + at(b))).norm(), 1e-14) << middle;
    EXPECT_NEAR((at(b) - at(a)).norm(), 1.0, 1e-14) << middle;
  }
}

// CalculiX's faces by the corners it lists for them.
TEST(CalculixModel, FacesAreNumberedAsCalculixDoes) {
  const Model model = pressed_cube(1, 1e6);
  const int corners[6][4] = {{1, 2, 3, 4}, {5, 8, 7, 6}, {1, 5, 6, 2},
                             {2, 6, 7, 3}, {3, 7, 8, 4}, {4, 8, 5, 1}};
  for (const auto& [name, outward] :
       {std::pair<std::string, Vector3d>{"x0", -Vector3d::UnitX()},
        {"x1", Vector3d::UnitX()},
        {"y0", -Vector3d::UnitY()},
        {"y1", Vector3d::UnitY()},
        {"z0", -Vector3d::UnitZ()},
        {"z1", Vector3d::UnitZ()}}) {
    const auto& faces = group(model, name).faces;
    ASSERT_EQ(faces.size(), 1U);
    Vector3d mean = Vector3d::Zero();
    for (const int corner : corners[faces[0].face - 1]) {
      mean +=
          0.25 * model.nodes.col(
                     model.elements[0][static_cast<std::size_t>(corner - 1)]);
    }
    EXPECT_LT((mean - Vector3d::Constant(0.5) - 0.5 * outward).norm(), 1e-14)
        << name;
  }
}

// A uniform pressure on an 8-node face: -1/12 at corners, +1/3 at middles.
TEST(CalculixModel, UniformPressureHasTheSerendipityWeights) {
  const double pressure = 12e6;
  const Model model = pressed_cube(1, pressure);
  double sum = 0.0;
  for (const int node : group(model, "x1").nodes) {
    const double force = model.loads(3 * node, 0);
    const double weight =
        is_corner(model.nodes.col(node)) ? -1.0 / 12 : 1.0 / 3;
    EXPECT_NEAR(force, -pressure * weight, 1e-9 * pressure);
    sum += force;
  }
  EXPECT_NEAR(sum, -pressure, 1e-9 * pressure);
  EXPECT_NEAR(model.loads.col(0).cwiseAbs().sum(),
              pressure * (4.0 / 12 + 4.0 / 3),
              1e-8 * pressure);  // nothing elsewhere
}

// `fixed` holds x at x0; what stays free (two slides, one turn) is not driven.
TEST(CalculixModel, LooseModesThatNothingDrivesAreHeldAtThreeComponents) {
  const Model model = pressed_cube(1, 1e6);
  EXPECT_EQ(model.supports.size(), 8U + 3U);
  int across = 0;
  for (const auto& support : model.supports) across += support.component != 0;
  EXPECT_EQ(across, 3);
}

TEST(CalculixModel, EnergyIsHalfTheWorkOfTheLoads) {
  const Model model = pressed_cube(1, 1e6);
  Eigen::Matrix3Xd displacement = Eigen::Matrix3Xd::Zero(3, model.nodes.cols());
  displacement.row(0) = -2e-6 * model.nodes.row(0);
  EXPECT_NEAR(strain_energy(model, 0, displacement), 1.0, 1e-9);
}

TEST(CalculixModel, LoadThatDrivesAFreeModeIsRefused) {
  const auto mesh =
      support::structured_mesh<3>({1, 1, 1}, 1, [](const Vector3d& x) {
        return x;
      });
  loads::InstantLoad instant;
  instant.rigid.acceleration = {0.0, 9.81, 0.0};
  loads::LoadHistory history;
  history.instants = {instant};
  const part::Material steel{"steel", 210e9, 0.3, 7850.0, 355e6};
  try {
    make_model({mesh, steel, history, {{"x0", {true, false, false}}}, "cube"},
               Hexahedron::kFull);
    FAIL() << "not refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "F001");
  }
}

}  // namespace
}  // namespace clevis::calculix
