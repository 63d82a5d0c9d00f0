#include "assessment/stretches/excited_modes.h"

#include <gtest/gtest.h>

namespace clevis::assessment {
namespace {

using Eigen::Vector3d;

constexpr double kApart = 0.02;

HeldModes modes(std::vector<ExcitedMode> all) {
  return {all.front().period, std::move(all)};
}

TEST(ExcitedModes, AreLikeWhereThoseThatCountAre) {
  const HeldModes held = modes({{1.0, 0.3}, {0.25, 1.0}});
  EXPECT_TRUE(are_like(held, modes({{1.015, 0.3}, {0.252, 1.0}}), kApart));
  // Across the loads nothing has changed, along them it has.
  const HeldModes changed = modes({{1.0, 0.3}, {0.5, 1.0}});
  EXPECT_FALSE(are_like(held, changed, kApart));
  EXPECT_FALSE(are_like(changed, held, kApart));
}

TEST(ExcitedModes, OfLittleAnswerNeedNotBeThere) {
  const HeldModes held = modes({{1.0, 0.02}, {0.25, 1.0}});
  EXPECT_TRUE(are_like(held, modes({{2.0, 0.04}, {0.25, 1.0}}), kApart));
  // One that counts finds its like among those that hardly do.
  EXPECT_TRUE(are_like(held, modes({{1.0, 0.06}, {0.25, 1.0}}), kApart));
  EXPECT_FALSE(are_like(held, modes({{2.0, 0.06}, {0.25, 1.0}}), kApart));
}

TEST(ExcitedModes, ChangesAreThoseOfTheExtremes) {
  loads::LoadHistory motion;
  const auto add = [&](double time, const Vector3d& force) {
    motion.instants.push_back(
        {.label = "",
         .time = time,
         .wrenches = {{.force = force, .moment = Vector3d::Zero()}},
         .surface_loads = {},
         .rigid = {}});
  };
  add(0.0, {5.0, 1.0, 0.0});
  add(0.1, {5.0, 3.0, 0.0});
  add(0.2, {5.0, 4.0, 1e-9});  // most along y
  add(0.3, {2.0, 1.0, 0.0});   // least along x
  const Eigen::MatrixXd changes = extreme_changes(motion);
  ASSERT_EQ(changes.cols(), 2);
  EXPECT_EQ(changes.col(0).head<2>(), Eigen::Vector2d(0.0, 3.0));
  EXPECT_EQ(changes.col(1).head<2>(), Eigen::Vector2d(-3.0, 0.0));
  motion.instants.resize(1);
  EXPECT_EQ(extreme_changes(motion).cols(), 0);
}

}  // namespace
}  // namespace clevis::assessment
