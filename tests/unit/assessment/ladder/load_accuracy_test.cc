#include "assessment/ladder/load_accuracy.h"

#include <gtest/gtest.h>

namespace clevis::assessment {
namespace {

using Eigen::VectorXd;

constexpr double kTolerance = 0.01;
constexpr double kAdmitted = 1e-4;  // a hundredth of it

PartJob moving_part(int instants = 50) {
  PartJob job;
  job.tolerance = kTolerance;
  job.load_sets.resize(1);
  job.load_sets.front().history.instants.resize(
      static_cast<std::size_t>(instants));
  return job;
}

/// Stress and deflection rise over the instants, the stress from 0.51 MPa, the
/// deflection to the last but ten.
Level<3> solved(const PartJob& job) {
  const auto n =
      static_cast<Eigen::Index>(job.load_sets.front().history.instants.size());
  Level<3> level;
  stress::StressHistory history;
  history.peak = VectorXd::LinSpaced(n, 0.51e6, 1e6);
  history.worst = Eigen::MatrixXd::Constant(1, 1, 1e6);
  history.peak_at = {0, 0};
  history.peak_instant = static_cast<int>(n - 1);
  stress::Deflection deflection;
  deflection.of_instant = VectorXd::Zero(n);
  deflection.of_instant[5] = deflection.value = 1e-3;
  level.histories = {history};
  level.deflections = {deflection};
  return level;
}

TEST(LoadAccuracy, InstantsThatMayGovernAreExact) {
  const PartJob job = moving_part();
  const auto admitted = admitted_load_errors<3>(job, solved(job));
  ASSERT_EQ(admitted.size(), 1U);
  EXPECT_DOUBLE_EQ(admitted[0][0], kAdmitted);
  EXPECT_EQ(admitted[0][5], 0.0);                // deflects most
  EXPECT_DOUBLE_EQ(admitted[0][38], kAdmitted);  // 0.89 MPa
  EXPECT_EQ(admitted[0][40], 0.0);               // 0.91 MPa
  EXPECT_EQ(admitted[0][49], 0.0);
}

TEST(LoadAccuracy, AllAreExactWhereThatIsCheapOrProbesWantIt) {
  const PartJob few = moving_part(39);
  EXPECT_TRUE(admitted_load_errors<3>(few, solved(few)).empty());
  PartJob probed = moving_part();
  part::LoadCaseDefinition load_case;
  load_case.probes.resize(1);
  probed.part.cases = {load_case};
  EXPECT_TRUE(admitted_load_errors<3>(probed, solved(probed)).empty());
}

TEST(LoadAccuracy, APeakOfAnInexactInstantIsSeen) {
  const PartJob job = moving_part();
  Level<3> level = solved(job);
  EXPECT_FALSE(peak_is_inexact<3>(level));
  level.admitted = admitted_load_errors<3>(job, level);
  EXPECT_FALSE(peak_is_inexact<3>(level));
  level.histories[0].peak_instant = 0;
  EXPECT_TRUE(peak_is_inexact<3>(level));
}

// Three times what is admitted, over the largest.
TEST(LoadAccuracy, InexactInstantsNearThePeakMayBeAboveIt) {
  const PartJob job = moving_part();
  Level<3> level = solved(job);
  level.admitted = {VectorXd::Zero(50)};
  level.admitted[0].head(49).setConstant(kAdmitted);
  EXPECT_EQ(rise_of_inexact<3>(level), 0.0);  // 0.99 MPa stays below
  level.histories[0].peak[48] = 0.9999e6;
  EXPECT_NEAR(rise_of_inexact<3>(level), 200.0, 1e-6);
  EXPECT_DOUBLE_EQ(inexact_deflection<3>(level, 0), 3e-4);
  level.admitted.clear();
  EXPECT_EQ(rise_of_inexact<3>(level), 0.0);
  EXPECT_EQ(inexact_deflection<3>(level, 0), 0.0);
}

}  // namespace
}  // namespace clevis::assessment
