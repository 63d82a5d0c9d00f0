// Vibration of a part after impacts against the wave in a bar. Source:
// docs/theory.md, "Vibration under a load history".

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "assessment/part_check.h"
#include "assessment/vibration/duration_ratio.h"
#include "assessment/vibration/load_pace.h"
#include "assessment/vibration/vibration_times.h"
#include "mesh/quality/mass_properties.h"
#include "part/verdict.h"
#include "support/structured_mesh.h"

namespace clevis::assessment {
namespace {

using Eigen::Vector3d;

/// No lateral contraction: waves along the bar keep their shape.
const part::Material kCork{"cork", 70e9, 0.0, 2700.0, 300e6};
const Vector3d kSize(0.3, 0.02, 0.01);
constexpr double kPull = 40e6;  // [Pa]

double transit() {
  return kSize.x() * std::sqrt(kCork.density / kCork.youngs_modulus);
}

loads::InstantLoad pulled(double time, double share) {
  loads::InstantLoad instant;
  instant.time = time;
  instant.label = "t";
  for (const auto& [name, side] : {std::pair{"x0", -1.0}, {"x1", 1.0}}) {
    loads::SurfaceLoad load;
    load.group = name;
    load.traction.x() = side * share * kPull;
    load.resultant.force = kSize.y() * kSize.z() * load.traction;
    load.total = load.resultant.force.norm();
    instant.surface_loads.push_back(load);
  }
  return instant;
}

/// A free bar that is pulled at both ends, by what rises evenly from t = 0 and
/// stays.
PartJob bar(double rise) {
  PartJob job;
  job.part.name = "bar";
  job.part.material = kCork;
  job.mesh = support::structured_mesh<3>(
      {20, 1, 1}, 1, [](const Vector3d& x) -> Vector3d {
        return kSize.cwiseProduct(x - Vector3d(0.0, 0.5, 0.5));
      });
  job.mass = mesh::mass_properties(job.mesh, kCork.density);
  LoadSet set;
  const double end = 20.0 * transit(), side = 1e-9 * transit();
  for (const auto& [t, share] :
       std::vector<std::pair<double, double>>{{-transit(), 0.0},
                                              {-side, 0.0},
                                              {0.0, 0.0},
                                              {rise, 1.0},
                                              {rise + side, 1.0},
                                              {end, 1.0}}) {
    set.history.instants.push_back(pulled(t, share));
  }
  job.load_sets.push_back(set);
  job.impact_loads.push_back(
      {.name = "touch", .duration = end, .rise_time = rise, .touches = {0.0}});
  return job;
}

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

/// A bar about x whose weight turns in its frame for three turns.
PartJob turning(double depth, double speed) {
  PartJob job = bar(transit());
  job.impact_loads.clear();
  job.mesh = support::structured_mesh<3>(
      {20, 2, 2}, 1, [&](const Vector3d& x) -> Vector3d {
        return Vector3d(kSize.x(), depth, kSize.z())
            .cwiseProduct(x - Vector3d(0.0, 0.5, 0.5));
      });
  job.mass = mesh::mass_properties(job.mesh, kCork.density);
  constexpr int kPerTurn = 40, kTurns = 3;
  auto& instants = job.load_sets.front().history.instants;
  instants.clear();
  for (int i = 0; i <= kPerTurn * kTurns; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kPerTurn;
    loads::InstantLoad instant;
    instant.time = angle / speed;
    instant.rigid.omega = speed * Vector3d::UnitX();
    instant.rigid.acceleration =
        9.81 * Vector3d(0.0, std::cos(angle), -std::sin(angle));
    instants.push_back(instant);
  }
  return job;
}

// What stands in space excites nothing of an even section; an uneven one sags
// twice a turn more and less, at its frequency where it spins at half of that.
TEST(LoadPace, WeightOfAPartThatSpins) {
  constexpr double kFirst = 1e-3;  // period [s]
  const double frequency = 2.0 * std::numbers::pi / kFirst;
  const auto stands = [&](double depth, double share) {
    const PartJob job = turning(depth, share * frequency);
    EXPECT_TRUE(spins_fast(job, job.load_sets.front(), kFirst));
    return stand_in_space(job, job.load_sets.front(), kFirst);
  };
  for (const double share : {0.05, 0.5, 0.7}) {
    EXPECT_TRUE(stands(kSize.z(), share)) << share;
  }
  EXPECT_TRUE(stands(2.0 * kSize.z(), 0.05));
  EXPECT_FALSE(stands(2.0 * kSize.z(), 0.5));
  EXPECT_FALSE(stands(2.0 * kSize.z(), 0.4));
  // A pull that stands in its frame beside the weight; one that does not.
  PartJob pulled_too = turning(kSize.z(), 0.5 * frequency);
  auto& instants = pulled_too.load_sets.front().history.instants;
  for (auto& instant : instants) instant.rigid.acceleration.y() += 30.0;
  EXPECT_TRUE(stand_in_space(pulled_too, pulled_too.load_sets.front(), kFirst));
  for (auto& instant : instants) {
    instant.rigid.acceleration.z() += 3.0 * std::sin(frequency * instant.time);
  }
  EXPECT_FALSE(
      stand_in_space(pulled_too, pulled_too.load_sets.front(), kFirst));
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

// What stands still in the same component hides nothing either.
TEST(LoadPace, ChangesCountBesideWhatStandsStill) {
  for (const double preload : {0.0, 1e3}) {
    PartJob job = bar(transit());
    auto& instants = job.load_sets[0].history.instants;
    const double step = 1e-9 * transit();
    instants = {pulled(0.0, preload), pulled(5.0 * transit(), preload),
                pulled(5.0 * transit() + step, preload + 1.0),
                pulled(10.0 * transit(), preload + 1.0)};
    const auto components = load_components(job, job.load_sets.front());
    EXPECT_FALSE(is_slow(job, job.load_sets.front(), components));
    EXPECT_NEAR(load_spectrum(job, components, transit()).amplification, 2.0,
                0.02);
  }
}

// A block on a neck vibrates far slower than a bar of its size: loads that are
// slow beside the bar are not beside the block.
TEST(LoadPace, ANeckMakesAPartSlow) {
  PartJob job = bar(transit());
  job.impact_loads.clear();
  job.load_sets[0].fixed = {{"x0", {true, true, true}}};
  job.mesh = support::structured_mesh<3>(
      {20, 2, 2}, 1, [](const Vector3d& x) -> Vector3d {
        const double height =
            0.06 + 0.94 / (1.0 + std::exp(-(x.x() - 0.5) / 0.04));
        return kSize.cwiseProduct(
            Vector3d(x.x(), height * (x.y() - 0.5), x.z() - 0.5));
      });
  job.mass = mesh::mass_properties(job.mesh, kCork.density);
  auto& instants = job.load_sets[0].history.instants;
  instants.clear();
  const double rise = longest_period(job, job.load_sets.front());
  for (int i = 0; i <= 40; ++i) {  // a step across, in ten longest periods
    const double s = std::min(1.0, i / 20.0);
    instants.push_back(pulled(0.5 * rise * i, 0.0));
    instants.back().surface_loads.clear();
    instants.back().rigid.acceleration.y() = 10.0 * s * s * (3.0 - 2.0 * s);
  }
  const PartResult result = check_part(job).result;
  ASSERT_TRUE(result.first_period.has_value());
  EXPECT_GT(*result.first_period, rise);
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

// A held part that is shaken has no force on its surface but its supports'.
TEST(LoadPace, InertiaExcitesToo) {
  PartJob job = bar(transit());
  job.impact_loads.clear();
  job.load_sets[0].fixed = {{"x0", {true, true, true}}};
  auto& instants = job.load_sets[0].history.instants;
  const double step = 1e-9 * transit();
  instants.clear();
  for (const auto& [time, shake] : {std::pair{-transit(), 0.0},
                                    {-step, 0.0},
                                    {0.0, 1e5},
                                    {9.0 * transit(), 1e5}}) {
    instants.push_back(pulled(time, 0.0));
    instants.back().surface_loads.clear();
    instants.back().rigid.acceleration.x() = shake;
  }
  EXPECT_FALSE(is_slow(job, job.load_sets.front(),
                       load_components(job, job.load_sets.front())));
  const PartResult result = check_part(job).result;
  EXPECT_NEAR(result.peak.value, kCork.density * 1e5 * kSize.x(),
              0.01 * result.peak.value);
  EXPECT_NEAR(result.vibration.ratio.value(), 2.0, 0.06);
}

// A small force across a part may stress it more than a large one along it.
TEST(LoadPace, SmallComponentsCountToo) {
  PartJob job = bar(transit());
  auto& instants = job.load_sets[0].history.instants;
  const double step = 1e-9 * transit();
  instants = {pulled(0.0, 1.0), pulled(5.0 * transit(), 1.0),
              pulled(5.0 * transit() + step, 1.0),
              pulled(10.0 * transit(), 1.0)};
  EXPECT_TRUE(is_slow(job, job.load_sets.front(),
                      load_components(job, job.load_sets.front())));
  const auto across = [&](double share) {
    for (const std::size_t i : {2U, 3U}) {
      for (auto& load : instants[i].surface_loads) {
        load.resultant.force.y() = share * load.resultant.force.x();
      }
    }
  };
  across(0.02);
  const auto components = load_components(job, job.load_sets.front());
  EXPECT_FALSE(is_slow(job, job.load_sets.front(), components));
  EXPECT_NEAR(load_spectrum(job, components, transit()).amplification, 2.0,
              0.02);
  // What stands still hides nothing but round-off.
  across(0.5e-3);
  EXPECT_FALSE(is_slow(job, job.load_sets.front(),
                       load_components(job, job.load_sets.front())));
  across(1e-5);
  EXPECT_FALSE(is_slow(job, job.load_sets.front(),
                       load_components(job, job.load_sets.front())));
  across(1e-10);
  EXPECT_TRUE(is_slow(job, job.load_sets.front(),
                      load_components(job, job.load_sets.front())));
}

}  // namespace
}  // namespace clevis::assessment
