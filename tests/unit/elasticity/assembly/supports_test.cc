#include "elasticity/assembly/supports.h"

#include <cmath>

#include <Eigen/SVD>
#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "part/supports.h"
#include "support/structured_mesh.h"

namespace clevis::elasticity {
namespace {

using Eigen::Vector3d;

Discretization<3> block() {
  return discretize<3>(support::structured_mesh<3>(
                           {2, 1, 1}, 1,
                           [](const Vector3d& x) -> Vector3d {
                             return {0.2 * x[0], 0.1 * x[1], 0.05 * x[2]};
                           }),
                       2);
}

std::string complaint(const part::Supports& fixed) {
  const auto discretization = block();
  try {
    fixed_supports<3>(discretization, node_positions(discretization), fixed,
                      "part P");
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "F001");
    EXPECT_EQ(error.place(), "part P");
    return error.problem();
  }
  return "";
}

TEST(Supports, DeterminateOnesHoldEveryRigidModeOnce) {
  const auto discretization = block();
  const auto positions = node_positions(discretization);
  const auto held = determinate_supports<3>(discretization, positions);
  ASSERT_EQ(held.size(), 6U);
  const auto modes = rigid_modes<3>(positions, positions.rowwise().mean(), 0.2);
  Eigen::MatrixXd rows(6, 6);
  for (int k = 0; k < 6; ++k) {
    rows.row(k) = modes.row(held[static_cast<std::size_t>(k)]);
  }
  const auto sigma = Eigen::JacobiSVD<Eigen::MatrixXd>(rows).singularValues();
  EXPECT_GT(sigma[5], 0.1 * sigma[0]);
}

TEST(Supports, ClampedFaceHolds) {
  EXPECT_EQ(complaint({{"x0", {true, true, true}}}), "");
  EXPECT_EQ(complaint({{"x0", {true, false, false}},
                       {"y0", {false, true, false}},
                       {"z0", {false, false, true}}}),
            "");
}

TEST(Supports, FreeTranslationIsNamed) {
  const auto text =
      complaint({{"x0", {false, true, true}}, {"y0", {false, true, true}}});
  EXPECT_NE(text.find("translation along"), std::string::npos) << text;
  EXPECT_EQ(text.find("rotation"), std::string::npos) << text;
  EXPECT_TRUE(text.find("(1, ") != std::string::npos ||
              text.find("(-1, ") != std::string::npos)
      << text;
}

TEST(Supports, FreeRotationIsNamed) {
  // Only normal to a face: it may slide along and turn about its normal.
  const auto text = complaint({{"z0", {false, false, true}}});
  EXPECT_NE(text.find("translation along"), std::string::npos) << text;
  EXPECT_NE(text.find("rotation about"), std::string::npos) << text;
}

TEST(Supports, NothingHeldIsRefused) {
  EXPECT_NE(complaint({{"x0", {false, false, false}}}).find("free"),
            std::string::npos);
}

}  // namespace
}  // namespace clevis::elasticity
