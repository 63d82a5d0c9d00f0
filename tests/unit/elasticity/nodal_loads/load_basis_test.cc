#include "elasticity/nodal_loads/load_basis.h"

#include <cmath>

#include <Eigen/QR>
#include <gtest/gtest.h>

#include "elasticity/nodal_loads/split_columns.h"
#include "elasticity/solid/plane_loads.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;

/// 40 × 12, singular values 10^(−decades k).
MatrixXd history_of(double decades) {
  std::srand(3);
  const MatrixXd left =
      MatrixXd::Random(40, 12).householderQr().householderQ() *
      MatrixXd::Identity(40, 12);
  const MatrixXd right =
      MatrixXd::Random(12, 12).householderQr().householderQ();
  Eigen::VectorXd sigma(12);
  for (Index k = 0; k < 12; ++k) {
    sigma[k] = std::pow(10.0, -decades * static_cast<double>(k));
  }
  return left * sigma.asDiagonal() * right;
}

TEST(LoadBasis, FindsTheRank) {
  const MatrixXd factors = MatrixXd::Random(40, 3);
  const auto basis = compress(factors * MatrixXd::Random(3, 25), 1e-7);
  EXPECT_EQ(basis.columns.cols(), 3);
  EXPECT_EQ(basis.coefficients.cols(), 25);
  EXPECT_LT(basis.compression_error, 1e-12);
}

TEST(LoadBasis, ErrorKeepsTheTolerance) {
  const MatrixXd history = history_of(0.8);
  Index last_rank = 0;
  for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
    const auto basis = compress(history, tolerance);
    const MatrixXd rest = history - basis.columns * basis.coefficients;
    const double error =
        rest.colwise().norm().maxCoeff() / history.colwise().norm().maxCoeff();
    EXPECT_NEAR(basis.compression_error, error, 1e-12);
    EXPECT_LE(error, 1.5 * tolerance);
    EXPECT_GT(basis.columns.cols(), last_rank);
    EXPECT_LT(basis.columns.cols(), 12);
    last_rank = basis.columns.cols();
  }
}

TEST(LoadBasis, ZeroHistoryHasNoColumns) {
  const auto basis = compress(MatrixXd::Zero(9, 4), 1e-6);
  EXPECT_EQ(basis.columns.cols(), 0);
  EXPECT_EQ(basis.columns.rows(), 9);
  EXPECT_EQ(basis.coefficients.rows(), 0);
  EXPECT_EQ(basis.coefficients.cols(), 4);
  EXPECT_EQ(basis.compression_error, 0.0);
}

TEST(LoadBasis, SingleColumnIsItself) {
  const MatrixXd history = 1e5 * MatrixXd::Random(9, 1);
  const auto basis = compress(history, 1e-6);
  ASSERT_EQ(basis.columns.cols(), 1);
  EXPECT_LT((basis.columns * basis.coefficients - history).norm(),
            1e-14 * history.norm());
}

/// Columns 0, 2 and 4 have entries in rows 5 to 12 only; 3 is twice 1.
MatrixXd few_and_wide() {
  std::srand(5);
  MatrixXd columns = MatrixXd::Random(900, 5);
  for (const Index k : {0, 2, 4}) {
    columns.col(k).head(5).setZero();
    columns.col(k).tail(900 - 13).setZero();
  }
  columns.col(3) = 2.0 * columns.col(1);
  return columns;
}

TEST(SplitColumns, HasTheProductsOfTheWhole) {
  const MatrixXd mixed = few_and_wide();
  const MatrixXd x = MatrixXd::Random(5, 7), modes = MatrixXd::Random(900, 3);
  for (const MatrixXd& given :
       {mixed, MatrixXd(mixed(Eigen::all, std::vector<int>{0, 2, 4, 0, 2})),
        MatrixXd(MatrixXd::Random(900, 5))}) {
    const SplitLoads loads = split({given, MatrixXd::Identity(5, 5)});
    const MatrixXd columns = given * loads.coefficients.transpose();
    const SplitColumns& parts = loads.columns;
    const MatrixXd gram = columns.transpose() * columns;
    const MatrixXd times = columns * x;
    const MatrixXd across = modes.transpose() * columns;
    EXPECT_EQ(parts.whole(), columns);
    EXPECT_EQ(parts.middle_rows(4, 3), columns.middleRows(4, 3));
    EXPECT_LT((parts.gram() - gram).norm(), 1e-13 * gram.norm());
    EXPECT_LT((parts.times(x) - times).norm(), 1e-13 * times.norm());
    EXPECT_LT((parts.transposed_times(modes) - across).norm(),
              1e-13 * across.norm());
    const double sum = times.cwiseAbs().colwise().sum().maxCoeff();
    EXPECT_NEAR(parts.largest_column_sum(x), sum, 1e-12 * sum);
    EXPECT_NEAR(parts.magnitudes()[1], columns.col(1).lpNorm<1>(), 1e-12 * sum);
  }
}

TEST(SplitColumns, KeepsWhatItIsToldAndTakesMoreBehind) {
  const SplitLoads loads = split({few_and_wide(), MatrixXd::Identity(5, 5)});
  SplitColumns parts = loads.columns;
  const MatrixXd before = parts.whole(), more = MatrixXd::Random(900, 1);
  parts.keep({1, 3, 4});
  parts.append(more);
  MatrixXd wanted(900, 4);
  wanted << before.col(1), before.rightCols(2), more;
  EXPECT_EQ(parts.whole(), wanted);
}

TEST(LoadBasis, DependentColumnsAreTheirHistory) {
  const LoadBasis loads{few_and_wide(), MatrixXd::Random(5, 20)};
  const MatrixXd history = loads.columns * loads.coefficients;
  const auto basis = compress(split(loads), 1e-7);
  EXPECT_EQ(basis.columns.cols(), 4);
  EXPECT_LT((basis.columns * basis.coefficients - history).norm(),
            1e-11 * history.norm());
}

// Half of the instants is made up of fewer columns than are needed for all; the
// others stay exact.
TEST(LoadBasis, InstantsKeepWhatIsAdmittedOfEach) {
  const MatrixXd history = history_of(0.4);
  const LoadBasis loads{history, MatrixXd::Identity(12, 12)};
  const double largest = history.colwise().norm().maxCoeff();
  constexpr double kTolerance = 1e-7;
  Eigen::VectorXd admitted = Eigen::VectorXd::Zero(12);
  admitted.tail(8).setConstant(3e-2);
  const auto basis = compress(split(loads), kTolerance, largest, admitted);
  EXPECT_LT(basis.columns.cols(),
            compress(split(loads), kTolerance, largest).columns.cols());
  const Eigen::RowVectorXd error =
      (history - basis.columns * basis.coefficients).colwise().norm() / largest;
  EXPECT_LE(error.head(4).maxCoeff(), 1.5 * kTolerance);
  EXPECT_LE(error.tail(8).maxCoeff(), 1.5 * 3e-2);
  EXPECT_GT(error.tail(8).maxCoeff(), 1e-4);
  EXPECT_LE(basis.compression_error, 1.5 * kTolerance);
}

TEST(LoadsInPlane, TellsPlaneFromSpatialLoads) {
  loads::LoadHistory history;
  history.seats.push_back(
      {"A", "bore_A", loads::SeatKind::kBearing, Vector3d(0.1, 0.0, 0.004)});
  loads::InstantLoad instant;
  instant.wrenches.push_back({Vector3d(100, 50, 0), Vector3d(0, 0, 2)});
  instant.rigid.acceleration = {1, -9.81, 0};
  instant.rigid.omega = {0, 0, 3};
  history.instants.push_back(instant);
  EXPECT_TRUE(loads_in_plane(history, 0.004, 0.1));
  // Off the plane the force bends the plate.
  EXPECT_FALSE(loads_in_plane(history, 0.005, 0.1));
  auto& load = history.instants[0];
  load.wrenches[0].force.z() = 1e-3;
  EXPECT_FALSE(loads_in_plane(history, 0.004, 0.1));
  load.wrenches[0].force.z() = 0.0;
  load.wrenches[0].moment.x() = 1e-3;
  EXPECT_FALSE(loads_in_plane(history, 0.004, 0.1));
  load.wrenches[0].moment.x() = 0.0;
  load.rigid.alpha.y() = 1e-3;
  EXPECT_FALSE(loads_in_plane(history, 0.004, 0.1));
}

TEST(LoadsInPlane, RoundOffOfAClosedPressureStaysInThePlane) {
  loads::SurfaceLoad pressure;
  pressure.group = "bore_A";
  pressure.pressure = 1e7;
  pressure.total = 3000.0;
  pressure.resultant = {.force = Vector3d(1e-13, -2e-13, 3e-13),
                        .moment = Vector3d(4e-15, 5e-15, 0)};
  loads::InstantLoad instant;
  instant.surface_loads.push_back(pressure);
  loads::LoadHistory history;
  history.instants.push_back(instant);
  EXPECT_TRUE(loads_in_plane(history, 0.0, 0.04));
}

}  // namespace
}  // namespace clevis::elasticity
