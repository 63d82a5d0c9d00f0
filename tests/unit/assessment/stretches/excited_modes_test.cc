#include "assessment/stretches/excited_modes.h"

#include <gtest/gtest.h>

namespace clevis::assessment {
namespace {

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

TEST(ExcitedModes, ChangesHaveTheLargestOfEachSeat) {
  constexpr int kInstants = 1000, kBlow = 501;
  loads::LoadHistory motion;
  for (int i = 0; i < kInstants; ++i) {
    const double shaken = i % 2 == 0 ? 0.0 : 2.0;
    motion.instants.push_back(
        {.label = "",
         .time = 1e-3 * i,
         .wrenches = {{.force = {5.0 + shaken, 1.0, 0.0},
                       .moment = {0.0, 0.0, i == kBlow ? 7.0 : 0.0}}},
         .surface_loads = {},
         .rigid = {}});
  }
  const Eigen::MatrixXd changes = seat_changes(motion);
  EXPECT_GT(changes.cols(), 10);
  EXPECT_LT(changes.cols(), 70);
  EXPECT_EQ(changes.row(0).minCoeff(), 2.0);  // what changes nothing is none
  EXPECT_EQ(changes.row(1).lpNorm<Eigen::Infinity>(), 0.0);
  EXPECT_EQ(changes.row(5).maxCoeff(), 7.0);
  motion.instants.resize(1);
  EXPECT_EQ(seat_changes(motion).cols(), 0);
}

}  // namespace
}  // namespace clevis::assessment
