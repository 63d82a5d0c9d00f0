#include "assessment/places/meeting_places.h"

#include <memory>

#include <gtest/gtest.h>

#include "support/structured_mesh.h"

namespace clevis::assessment {
namespace {

/// Two squares side by side, stress at their corners.
/// @param left, right  per corner, x first [Pa].
Level<2> two_cells(const Eigen::Vector4d& left, const Eigen::Vector4d& right) {
  Level<2> level;
  auto basis = std::make_shared<elasticity::DisplacementBasis<2>>();
  basis->discretization = elasticity::discretize<2>(
      support::structured_mesh<2>({2, 1}, 1,
                                  [](const Eigen::Vector2d& x) {
                                    return x;
                                  }),
      1);
  level.bases = {basis};
  stress::StressHistory history;
  history.subdivisions = 1;
  history.worst.resize(4, 2);
  history.worst << left, right;
  history.worst_instant.setZero(4, 2);
  level.histories = {history};
  return level;
}

CellAgreement agreement(const Eigen::Vector4d& left,
                        const Eigen::Vector4d& right) {
  const Level<2> level = two_cells(left, right);
  return cell_agreement<2>(level, level.histories);
}

TEST(CellAgreement, MeanAndJumpOfTheCellsThatMeet) {
  const auto cells = agreement({1.0, 100.0, 1.0, 90.0}, {80.0, 1.0, 88.0, 1.0});
  EXPECT_DOUBLE_EQ(cells.mean, 90.0);
  EXPECT_DOUBLE_EQ(cells.jump, 20.0);
}

// Where the peak is at a corner of one cell, a jump far below says nothing.
TEST(CellAgreement, JumpsFarBelowThePeakDoNotCount) {
  const auto cells =
      agreement({100.0, 60.0, 1.0, 50.0}, {20.0, 1.0, 49.0, 1.0});
  EXPECT_DOUBLE_EQ(cells.mean, 100.0);
  EXPECT_DOUBLE_EQ(cells.jump, 0.0);
}

TEST(CellAgreement, PointsOfAZoneLeftOutDoNotCount) {
  const auto cells = agreement({50.0, -1.0, 1.0, 40.0}, {52.0, 1.0, 36.0, 1.0});
  EXPECT_DOUBLE_EQ(cells.mean, 50.0);
}

}  // namespace
}  // namespace clevis::assessment
