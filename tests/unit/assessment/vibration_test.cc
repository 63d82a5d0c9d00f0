// Vibration of a part after impacts against the wave in a bar. Source:
// docs/theory.md, "Vibration under a load history".

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "assessment/part_check.h"
#include "assessment/stretches/vibration_times.h"
#include "assessment/vibration/duration_ratio.h"
#include "part/verdict.h"
#include "support/structured_mesh.h"
#include "unit/assessment/pulled_bar.h"

namespace clevis::assessment {
namespace {

using Eigen::Vector3d;

// Waves from both ends meet in the middle: twice the pull where it rises within
// a transit.
void expect_doubled(std::optional<ModelKind> model, const std::string& name) {
  PartJob job = bar(0.8 * transit());
  job.model = model;
  const PartResult result = check_part(job).result;
  EXPECT_NEAR(result.peak.value, kPull, 1e-6 * kPull);
  const VibrationResult& found = result.vibration;
  EXPECT_EQ(found.model, name);
  EXPECT_NEAR(found.ratio.value(), 2.0, 0.02);
  EXPECT_LE(found.band_low, 2.0 * kPull);
  EXPECT_GE(found.band_high, 2.0 * kPull);
  EXPECT_LT(found.error(), 0.05);
  EXPECT_LT(found.lowest_frequency, 0.5 / transit());  // bending's are lower
  EXPECT_GT(found.highest_frequency, 10.0 / transit());
  EXPECT_NEAR(result.safety_factor, 300e6 / found.peak, 1e-9);
}

TEST(Vibration, WavesFromBothEndsOfAPlateDouble) {
  expect_doubled(std::nullopt, "plane stress, p = 4");
}

TEST(Vibration, WavesFromBothEndsOfASolidDouble) {
  expect_doubled(ModelKind::kSolid, "3-D, p = 3");
}

TEST(Vibration, DecidesTheVerdict) {
  PartJob job = bar(0.8 * transit());
  job.part.limits.safety_factor = 5.0;  // 7.5 at rest, 3.75 in the wave
  const PartResult result = check_part(job).result;
  EXPECT_EQ(result.verdict, part::Verdict::kFail);
  EXPECT_NE(result.why.find("with vibration"), std::string::npos) << result.why;
  job.impact_loads.clear();  // the loads rise as fast without its name
  EXPECT_EQ(check_part(job).result.verdict, part::Verdict::kFail);
}

// The ratio is of the motion's peak: a case keeps its own.
TEST(Vibration, CaseThatStressesMoreKeepsItsPeak) {
  PartJob job = bar(0.8 * transit());
  job.part.cases.emplace_back().name = "hard";
  auto& instants = job.load_sets[0].history.instants;
  for (const double share : {1.5, 3.0}) {
    instants.push_back(pulled(0.0, share));
    instants.back().label = "hard";
    const PartResult result = check_part(job).result;
    EXPECT_NEAR(result.peak.value, share * kPull, 1e-6 * kPull);
    EXPECT_NEAR(result.vibration.ratio.value(), 2.0, 0.02);
    EXPECT_EQ(result.vibration.governs, share < 2.0);
    EXPECT_NEAR(result.safety_factor, 7.5 / std::max(2.0, share), 0.05);
    instants.pop_back();
  }
}

TEST(Vibration, SlowLoadsAreNotComputedInTime) {
  PartJob job = bar(1000.0 * transit());
  auto& instants = job.load_sets[0].history.instants;
  instants.back().time = 2000.0 * transit();
  job.impact_loads[0].duration = 2000.0 * transit();
  const PartResult result = check_part(job).result;
  ASSERT_EQ(result.duration_ratios.size(), 1U);
  EXPECT_NE(result.duration_ratios[0].treatment.find("quasi-static"),
            std::string::npos);
  EXPECT_FALSE(result.vibration.ratio);
}

TEST(Vibration, DampingLowersIt) {
  PartJob job = bar(0.8 * transit());
  job.part.damping = 0.05;
  const double damped = check_part(job).result.vibration.ratio.value();
  EXPECT_LT(damped, 1.95);
  EXPECT_GT(damped, 1.5);
}

// What the part does as a whole is told by the mesh before `refine`.
TEST(DurationRatios, PeriodIsOfTheMeshBeforeItsRefinement) {
  const auto period_of = [](const PartJob& job) {
    PartResult result;
    HeldMotions held(job);
    judge_load_pace(job, 0, held, result);
    return result.first_period.value();
  };
  const PartJob fine = bar(0.8 * transit());
  PartJob coarse = fine;
  coarse.mesh = support::structured_mesh<3>(
      {2, 1, 1}, 1, [](const Vector3d& x) -> Vector3d {
        return kSize.cwiseProduct(x - Vector3d(0.0, 0.5, 0.5));
      });
  PartJob refined = fine;
  refined.unrefined = coarse.mesh;
  EXPECT_EQ(period_of(refined), period_of(coarse));
  EXPECT_GT(std::abs(period_of(fine) / period_of(coarse) - 1.0), 1e-6);
}

// A jump of the loads excites as an impact does: no touch is needed.
TEST(Vibration, JumpOfTheLoadsDoubles) {
  PartJob job = bar(0.8 * transit());
  const double side = 1e-9 * transit(), end = 20.0 * transit();
  job.load_sets[0].history.instants = {pulled(-transit(), 0.5),
                                       pulled(-side, 0.5), pulled(0.0, 1.0),
                                       pulled(end, 1.0)};
  job.impact_loads.clear();
  job.part.damping = 0.01;
  const PartResult result = check_part(job).result;
  ASSERT_EQ(result.duration_ratios.size(), 1U);
  EXPECT_NEAR(result.duration_ratios[0].amplification,
              1.0 + std::exp(-0.01 * std::numbers::pi), 1e-3);
  const VibrationResult& found = result.vibration;
  // Of the modes' alternating sum each has e^(-ζ n π) left when the waves meet.
  const double exact = 1.0 + 2.0 / std::numbers::pi *
                                 std::atan(std::exp(-0.01 * std::numbers::pi));
  EXPECT_NEAR(found.ratio.value(), exact, 1e-3);
  EXPECT_GE(found.band_high, exact * kPull);

  job.load_sets[0].history.instants[2] = pulled(0.0, 0.505);
  job.load_sets[0].history.instants[3] = pulled(end, 0.505);
  const auto small = check_part(job).result.vibration;  // by 1 %
  EXPECT_NEAR(small.ratio.value(), 1.0 + 0.01 * (exact - 1.0) / 0.5, 2e-3);
}

/// Of a mode of the bar along it, n half waves.
double frequency(int n) {
  return 0.5 * n / transit();
}

// Whatever the shape: a ramp that rises within a wave's way over a cell, and
// forty steps within a fifth of the transit.
TEST(Vibration, SharpRampAndStairsDoubleAsAJump) {
  const double end = 8.0 * transit(), side = 1e-9 * transit();
  PartJob ramp = bar(0.02 * transit());
  ramp.impact_loads.clear();
  PartJob stairs = ramp;
  auto& instants = stairs.load_sets[0].history.instants;
  instants = {pulled(-transit(), 0.0)};
  constexpr int kSteps = 40;
  for (int i = 0; i < kSteps; ++i) {
    const double at = 0.2 * transit() * i / kSteps;
    instants.push_back(pulled(at - side, 1.0 * i / kSteps));
    instants.push_back(pulled(at, (i + 1.0) / kSteps));
  }
  instants.push_back(pulled(end, 1.0));
  for (const PartJob& job : {ramp, stairs}) {
    const PartResult result = check_part(job).result;
    EXPECT_NEAR(result.peak.value, kPull, 1e-6 * kPull);
    EXPECT_NEAR(result.vibration.peak, 2.0 * kPull, 0.01 * kPull);
    EXPECT_LE(result.vibration.band_low, 2.0 * kPull);
    EXPECT_GE(result.vibration.band_high, 2.0 * kPull);
    ASSERT_EQ(result.duration_ratios.size(), 1U);
    EXPECT_NEAR(result.duration_ratios[0].amplification, 2.0, 0.02);
  }
}

// Six cycles at the bar's first frequency; harmonics follow at rest. The mode's
// share of an even pull is 4/π in the middle, where its swing grows by π/2 a
// half cycle.
TEST(Vibration, SineAtAFrequencyOfThePartGrows) {
  PartJob job = bar(transit());
  job.impact_loads.clear();
  auto& instants = job.load_sets[0].history.instants;
  instants.clear();
  constexpr int kCycles = 6, kPerCycle = 24;
  for (int i = 0; i <= kCycles * kPerCycle; ++i) {
    const double turn = 2.0 * std::numbers::pi * i / kPerCycle;
    instants.push_back(pulled(i / (kPerCycle * frequency(1)), std::sin(turn)));
  }
  const PartResult result = check_part(job).result;
  const double exact = 4.0 / std::numbers::pi * std::numbers::pi * kCycles;
  EXPECT_NEAR(result.vibration.ratio.value(), exact, 0.02 * exact);
  EXPECT_GT(result.duration_ratios[0].amplification, std::numbers::pi * 5.0);
}

// Held by the ground at one end and pulled at the other at once, the wave comes
// back from there: twice the pull, and first at the held end.
TEST(Vibration, GroundHoldsASeat) {
  PartJob job = bar(transit());
  job.impact_loads.clear();
  LoadSet& set = job.load_sets[0];
  loads::Seat seat{.name = "weld",
                   .group = "x0",
                   .kind = loads::SeatKind::kTraction,
                   .p_LS = Vector3d::Zero()};
  set.history.seats = {seat};
  set.history.hold = [](double) {
    return loads::SeatHold{.held = Eigen::MatrixXd::Identity(6, 6),
                           .weighed = Eigen::MatrixXd(6, 0)};
  };
  const double side = 1e-9 * transit();
  set.history.instants = {pulled(-transit(), 0.0), pulled(-side, 0.0),
                          pulled(0.0, 1.0), pulled(9.0 * transit(), 1.0)};
  for (auto& instant : set.history.instants) {
    auto& held = instant.surface_loads.front();  // x0
    instant.wrenches = {{held.resultant.force, Vector3d::Zero()}};
    instant.surface_loads.erase(instant.surface_loads.begin());
  }
  for (const auto model : {ModelKind::kPlaneStress, ModelKind::kSolid}) {
    job.model = model;
    const PartResult result = check_part(job).result;
    const VibrationResult& found = result.vibration;
    EXPECT_NEAR(found.ratio.value(), 2.0, 0.04);
    EXPECT_LE(found.band_low, 2.0 * kPull);
    EXPECT_GE(found.band_high, 2.0 * kPull);
    // Bending, held at one end: λ² = 3.516.
    const double across = kSize.z() / std::sqrt(12.0);
    EXPECT_NEAR(result.first_period.value(),
                2.0 * std::numbers::pi * kSize.x() * kSize.x() /
                    (3.516 * across * (kSize.x() / transit())),
                0.01 * result.first_period.value());
  }
}

// What the shapes cannot follow is in the band, not lost.
TEST(Vibration, PulseShorterThanItsShapesWidensTheBand) {
  PartJob job = bar(transit());
  job.impact_loads.clear();
  const double pulse = 0.02 * transit();
  job.load_sets[0].history.instants = {
      pulled(-transit(), 0.0), pulled(0.0, 0.0), pulled(0.5 * pulse, 1.0),
      pulled(pulse, 0.0), pulled(8.0 * transit(), 0.0)};
  const VibrationResult found = check_part(job).result.vibration;
  EXPECT_LT(found.band_low, kPull);
  EXPECT_GT(found.band_high, 1.9 * kPull);
}

TEST(VibrationWindows, MeetAndJoin) {
  const auto windows =
      vibration_windows({0.5, 3.0, 8.0, 40.0, 598.0}, 1.0, {0.0, 600.0});
  ASSERT_EQ(windows.size(), 3U);
  EXPECT_EQ(windows[0].from, 0.0);  // the motion's begin comes later
  EXPECT_EQ(windows[0].to, 13.0);   // five periods
  EXPECT_EQ(windows[1].from, 39.0);
  EXPECT_EQ(windows[1].to, 45.0);
  EXPECT_EQ(windows[2].to, 600.0);
  const auto times = times_within({windows[0], windows[1]}, 1e-6, 190);
  EXPECT_NEAR(static_cast<double>(times.size()), 192.0, 2.0);
  EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));

  const double damping = 0.1;  // to a twentieth in 4.8 periods
  const auto swing =
      swing_windows({windows[0], windows[1]}, 1.0, damping, 600.0);
  ASSERT_EQ(swing.size(), 2U);
  EXPECT_NEAR(swing[0].to, 13.0 + 4.768, 1e-3);
  const auto undamped =
      swing_windows({windows[0], windows[1]}, 1.0, 0.0, 130.0);
  ASSERT_EQ(undamped.size(), 1U);
  EXPECT_EQ(undamped[0].to, 130.0);  // the motion's end comes first
}

// A load set that stresses less may deflect more.
TEST(Vibration, OtherLoadsKeepTheirDeflection) {
  PartJob job = bar(0.8 * transit());
  job.impact_loads.clear();
  const double alone = check_part(job).result.deflection;
  LoadSet across;
  across.fixed = {{"x0", {true, true, true}}};
  auto load = pulled(0.0, 0.0);
  load.label = "across";
  load.surface_loads.erase(load.surface_loads.begin());
  load.surface_loads[0].traction = {0.0, 0.0, 2e4};
  load.surface_loads[0].resultant.force = {0.0, 0.0,
                                           2e4 * kSize.y() * kSize.z()};
  load.surface_loads[0].resultant.moment =
      Vector3d(kSize.x(), 0.0, 0.0)
          .cross(load.surface_loads[0].resultant.force);
  load.surface_loads[0].total = load.surface_loads[0].resultant.force.norm();
  across.history.instants = {load};
  job.load_sets.push_back(across);
  const double force = load.surface_loads[0].total;
  const double bent =
      force * std::pow(kSize.x(), 3) * 12.0 /
      (3.0 * kCork.youngs_modulus * kSize.y() * std::pow(kSize.z(), 3));
  ASSERT_GT(bent, 1.5 * alone);
  const PartResult result = check_part(job).result;
  EXPECT_GT(result.vibration.ratio.value(), 1.5);
  EXPECT_NEAR(result.deflection, bent, 0.02 * bent);
}

}  // namespace
}  // namespace clevis::assessment
