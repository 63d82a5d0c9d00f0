#include "loads/holds/seat_hold.h"

#include <cmath>

#include <gtest/gtest.h>

namespace clevis::loads {
namespace {

using Eigen::MatrixXd;

/// One seat; a body between it and the ground moves by z along x.
SeatHold with_body(double to_part, double to_ground) {
  SwingingBodies swinging{.held = MatrixXd(6, 0),
                          .sprung = MatrixXd::Zero(6, 2),
                          .followed = MatrixXd(1, 0),
                          .sprung_there = MatrixXd::Zero(1, 2)};
  swinging.sprung(0, 0) = std::sqrt(to_part);
  swinging.sprung_there(0, 0) = -std::sqrt(to_part);
  swinging.sprung_there(0, 1) = std::sqrt(to_ground);
  SeatHold hold{.held = MatrixXd(6, 0)};
  hold.left_out = {"spring"};
  hold.swinging = swinging;
  return hold;
}

double stiffness(const SeatHold& hold) {
  return hold.sprung.row(0).squaredNorm();
}

// A carriage between two springs gives way as both in series.
TEST(HeldSlowly, SpringsInSeries) {
  const SeatHold slow = held_slowly(with_body(300.0, 600.0));
  EXPECT_FALSE(slow.swinging);
  EXPECT_TRUE(slow.left_out.empty());
  EXPECT_NEAR(stiffness(slow), 200.0, 1e-9);
  EXPECT_NEAR(stiffness(held_slowly(with_body(300.0, 0.0))), 0.0, 1e-9);
}

// A joint makes it follow: of its springs that to the ground holds the part.
TEST(HeldSlowly, BodiesFollowByTheirJoints) {
  SeatHold hold = with_body(300.0, 600.0);
  hold.swinging->held = MatrixXd(Eigen::VectorXd::Unit(6, 0));
  hold.swinging->followed = -MatrixXd::Ones(1, 1);
  const SeatHold slow = held_slowly(hold);
  EXPECT_EQ(slow.held.cols(), 0);
  EXPECT_NEAR(stiffness(slow), 600.0, 1e-9);
}

}  // namespace
}  // namespace clevis::loads
