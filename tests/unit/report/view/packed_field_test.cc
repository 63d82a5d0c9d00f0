#include "report/view/packed_field.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace clevis::report {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// A load that runs around a bore: no few columns tell it exactly.
MatrixXd running_load(Index points, Index instants) {
  MatrixXd values(points, instants);
  for (Index i = 0; i < instants; ++i) {
    for (Index p = 0; p < points; ++p) {
      const double angle = 2.0 * M_PI *
                           (static_cast<double>(p) / double(points) -
                            0.4 * static_cast<double>(i) / double(instants));
      values(p, i) = (100.0 + double(i)) * std::max(0.0, std::cos(angle)) + 3.0;
    }
  }
  return values;
}

TEST(PackedField, TellsEveryValueWithinTheToleranceItNames) {
  const MatrixXd given = running_load(200, 60);
  constexpr double kTolerance = 0.2;
  const PackedField field = pack(given, 59, kTolerance, 64);
  const double error = (field.values() - given).cwiseAbs().maxCoeff();
  EXPECT_LE(error, kTolerance);
  EXPECT_NEAR(field.error, error, 1e-9);
  EXPECT_LE(field.scale.size(), given.cols());
}

TEST(PackedField, TellsTheFirstInstantNearlyExactly) {
  const MatrixXd given = running_load(200, 60);
  const PackedField field = pack(given, 17, 2.0, 64);
  const double largest = given.col(17).maxCoeff();
  EXPECT_LT((field.values() - given).col(17).cwiseAbs().maxCoeff(),
            3e-5 * largest);
}

TEST(PackedField, NamesTheErrorWhereTheColumnsDoNotSuffice) {
  const MatrixXd given = running_load(200, 60);
  const PackedField field = pack(given, 0, 1e-6, 3);
  EXPECT_EQ(field.scale.size(), 3);
  EXPECT_GT(field.error, 1.0);
  EXPECT_NEAR(field.error, (field.values() - given).cwiseAbs().maxCoeff(),
              1e-9);
}

TEST(PackedField, ColumnsOfEightBitsHoldNoMore) {
  const PackedField field = pack(running_load(200, 60), 0, 0.5, 64);
  ASSERT_TRUE(std::ranges::count(field.bits, 8) > 0);
  for (Index k = 0; k < field.integers.cols(); ++k) {
    const int largest = field.bits[std::size_t(k)] == 8 ? 127 : 32767;
    EXPECT_EQ(field.integers.col(k).cast<int>().cwiseAbs().maxCoeff(), largest);
  }
}

TEST(PackedField, NothingTakesNoColumn) {
  EXPECT_EQ(pack(MatrixXd::Zero(5, 3), 1, 0.0, 8).scale.size(), 0);
}

}  // namespace
}  // namespace clevis::report
