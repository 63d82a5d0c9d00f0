#include "report/view/packed_field.h"

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

TEST(PackedField, TellsTheFirstInstantToAnEighthAndItsLargestAsItIs) {
  constexpr double kTolerance = 2.0;
  const MatrixXd given = running_load(200, 60);
  const PackedField field = pack(given, 17, kTolerance, 64);
  Index worst = 0;
  const double largest = given.col(17).maxCoeff(&worst);
  const MatrixXd stored = field.values();
  EXPECT_LE((stored - given).col(17).cwiseAbs().maxCoeff(),
            kTolerance / 8 * (1 + 1e-6));
  // coefficients are of single precision
  EXPECT_NEAR(stored(worst, 17), largest, 2e-7 * largest);
}

TEST(PackedField, NamesTheErrorWhereTheColumnsDoNotSuffice) {
  const MatrixXd given = running_load(200, 60);
  const PackedField field = pack(given, 0, 1e-6, 3);
  EXPECT_EQ(field.scale.size(), 3);
  EXPECT_GT(field.error, 1.0);
  EXPECT_NEAR(field.error, (field.values() - given).cwiseAbs().maxCoeff(),
              1e-9);
}

// A step a hundredth as wide would be told by two digits more that only cost.
TEST(PackedField, ColumnsHaveNoFinerStepsThanTheToleranceAsksFor) {
  constexpr double kTolerance = 0.5;
  const PackedField field = pack(running_load(200, 60), 0, kTolerance, 64);
  ASSERT_GT(field.scale.size(), 2);
  EXPECT_GT(field.scale[0], kTolerance / 4.1);
  for (Index k = 1; k < field.scale.size(); ++k) {
    EXPECT_GT(field.scale[k], kTolerance / 3.1);
    EXPECT_LE(field.scale[k], kTolerance / 2);
  }
}

TEST(PackedField, AToleranceOfNothingIsBoundedByTheIntegers) {
  const MatrixXd given = running_load(20, 3);
  const PackedField field = pack(given, 0, 1e-12, 8);
  EXPECT_LE(field.integers.cast<int>().cwiseAbs().maxCoeff(), 32767);
  EXPECT_LT(field.error, 1e-4);
}

TEST(PackedField, NothingTakesNoColumn) {
  EXPECT_EQ(pack(MatrixXd::Zero(5, 3), 1, 0.0, 8).scale.size(), 0);
}

}  // namespace
}  // namespace clevis::report
