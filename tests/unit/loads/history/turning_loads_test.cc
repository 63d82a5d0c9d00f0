#include "loads/history/turning_loads.h"

#include <gtest/gtest.h>

namespace clevis::loads {
namespace {

TEST(TurningLoads, WhatTurnsWithThePartIsToldFromWhatStandsStill) {
  const Eigen::VectorXd angles = Eigen::VectorXd::LinSpaced(30, 0.3, 5.0);
  Eigen::MatrixXd loads(30, 2);
  loads.col(0) = 7.0 + 3.0 * angles.array().cos() - 2.0 * angles.array().sin();
  loads.col(1) = -4.0 * angles.array().sin();
  const Eigen::VectorXd common = share_that_turns_with(angles, loads);
  ASSERT_EQ(common.size(), 2);
  EXPECT_NEAR(common[0], 7.0, 1e-12);
  EXPECT_NEAR(common[1], 0.0, 1e-12);
}

}  // namespace
}  // namespace clevis::loads
