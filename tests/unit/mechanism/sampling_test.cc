#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "mechanism/sampling/slide_times.h"
#include "mechanism/simulate.h"
#include "support/off_cubic.h"
#include "support/reference_motions.h"

namespace clevis::mechanism {
namespace {

SimulationSettings at_peaks(double duration, int instants) {
  SimulationSettings s;
  s.duration = duration;
  s.instants = instants;
  s.tolerance = 1e-9;
  s.at_peaks = true;
  return s;
}

double largest_effort(const Motion& motion, std::size_t element) {
  double largest = 0.0;
  for (const Instant& i : motion.instants) {
    largest = std::max(largest, std::abs(i.elements[element].effort));
  }
  return largest;
}

/// The instants of the pair that stand on both sides of an event, or those
/// around it if there is no such pair.
std::pair<const Instant*, const Instant*> sides(const Motion& motion,
                                                double event) {
  const auto after =
      std::ranges::find_if(motion.instants, [&](const Instant& i) {
        return i.t > event + 1e-9;
      });
  return {&*(after - 1), &*after};
}

// 1 kg at 1 m/s against 1e8 N/m: 1e4 N for 0.3 ms, between two instants.
TEST(Sampling, BlowOnAStiffStop) {
  const Motion motion =
      simulate(testing::against_a_wall({.stiffness = 1e8}), at_peaks(0.4, 5));
  EXPECT_NEAR(largest_effort(motion, 1), 1e4, 1.0);
  // loads change little from instant to instant while they are large
  for (std::size_t i = 1; i < motion.instants.size(); ++i) {
    const double a = motion.instants[i - 1].elements[1].effort;
    const double b = motion.instants[i].elements[1].effort;
    if (std::max(a, b) > 0.95e4) EXPECT_LT(std::abs(b - a), 0.0051e4);
  }
}

// Friction falls from 1.5 N to 1 N when the mass breaks loose at 7.5 s.
TEST(Sampling, BothSidesOfASlip) {
  const Motion motion = simulate(
      testing::pulled({.breakaway = 1.5, .kinetic = 1.0}), at_peaks(10.0, 6));
  const auto [before, after] = sides(motion, 7.5);
  EXPECT_NEAR(before->t, 7.5, 1e-8);
  EXPECT_NEAR(after->t, 7.5, 1e-7);
  EXPECT_NEAR(std::abs(before->elements[1].effort), 1.5, 1e-7);
  EXPECT_NEAR(std::abs(after->elements[1].effort), 1.0, 1e-7);
  EXPECT_NEAR(largest_effort(motion, 0), 1.519615242271, 1e-5);
}

MechanismDefinition driven_into_a_spring() {
  MechanismDefinition m = testing::sliders({1.0});
  DriveDefinition drive;
  drive.joint = 0;
  drive.law = DriveLaw::kSine;
  drive.amplitude = 0.1;
  drive.frequency = 1.0;
  m.drives = {drive};
  m.elements = {testing::on_joint(
      0,
      StopLaw{.lower = {}, .upper = 0.05, .contact = {.stiffness = 1000.0}})};
  return m;
}

TEST(Sampling, DrivenIntoAStop) {
  const Motion motion = simulate(driven_into_a_spring(), at_peaks(1.0, 9));
  EXPECT_NEAR(largest_effort(motion, 0), 50.0, 1e-6);
  for (const double touch : {1.0 / 12.0, 5.0 / 12.0}) {
    const auto next =
        std::ranges::find_if(motion.instants, [&](const Instant& i) {
          return i.t > touch;
        });
    EXPECT_NEAR(next->t, touch, 5e-9);
    EXPECT_NEAR((next - 1)->t, touch, 5e-9);
    EXPECT_NE(next->elements[0].effort == 0.0,
              (next - 1)->elements[0].effort == 0.0);
  }
}

// A load that swings and fades to less than a hundredth: the curve through
// instants and repeats follows it to the end, however few are asked for.
TEST(Sampling, SmallLoadsOfAnIntegratedMotionAreFollowed) {
  constexpr double kOmega = 100.0, kDamping = 0.05;  // [rad/s], [1]
  const double own = kOmega * std::sqrt(1.0 - kDamping * kDamping);
  const double fall = kDamping * kOmega;
  const SpringLaw law{.stiffness = kOmega * kOmega, .damping = 2.0 * fall};
  const auto effort = [&](double t) {  // pushes 1 kg, at rest 1 m away
    const double decay = std::exp(-fall * t);
    const double x =
        decay * (std::cos(own * t) + fall / own * std::sin(own * t));
    const double v = -decay * kOmega * kOmega / own * std::sin(own * t);
    return law.stiffness * x + law.damping * v;
  };
  MechanismDefinition m = testing::sliders({1.0});
  m.elements = {testing::on_joint(0, law)};
  m.initial_joints = {
      {.joint = 0, .position = 1.0, .rate = std::nullopt, .place = {}}};
  const Motion motion = simulate(m, at_peaks(1.0, 5));
  EXPECT_EQ(motion.followed_until, std::numeric_limits<double>::infinity());
  const double missed = testing::off_cubic(
      motion, 1.0,
      [](const Instant& at) {
        return -at.elements[0].effort;
      },
      effort);
  EXPECT_LT(missed, 1e-3 * law.stiffness);
  EXPECT_GT(motion.repeats.size(), 50u);
  EXPECT_LT(motion.repeats.size(), 400u);
}

// A force over time of more corners than become instants, whose second half is
// a fifth of the first: its small swings are followed over their corners.
TEST(Sampling, CornersOfASmallLoadAreFollowed) {
  constexpr int kPerPeriod = 12, kPeriods = 100;
  constexpr double kFrequency = 100.0;  // [Hz]
  TableLaw law;
  for (int k = 0; k <= kPerPeriod * kPeriods; ++k) {
    const double size = 2 * k < kPerPeriod * kPeriods ? 1.0 : 0.2;
    law.times.push_back(k / (kPerPeriod * kFrequency));
    law.efforts.push_back(size *
                          std::sin(2.0 * std::numbers::pi * k / kPerPeriod));
  }
  MechanismDefinition m = testing::sliders({1.0});
  m.elements = {testing::on_joint(0, law)};
  const Motion motion = simulate(m, at_peaks(1.0, 5));
  EXPECT_EQ(motion.followed_until, std::numeric_limits<double>::infinity());
  std::vector<const Instant*> all;
  for (const auto* list : {&motion.instants, &motion.repeats}) {
    for (const Instant& at : *list) all.push_back(&at);
  }
  std::ranges::sort(all, {}, &Instant::t);
  double missed = 0.0;
  for (std::size_t i = 1; i < all.size(); ++i) {
    const auto straight = [&](double t) {  // between corners
      const auto k = static_cast<std::size_t>(kPerPeriod * kFrequency * t);
      const double part =
          (t - law.times[k]) / (law.times[k + 1] - law.times[k]);
      return std::lerp(law.efforts[k], law.efforts[k + 1], part);
    };
    const double from = all[i - 1]->t, to = all[i]->t;
    const double line = 0.5 * (straight(std::min(from, 0.9999)) +
                               straight(std::min(to, 0.9999)));
    missed = std::max(missed, std::abs(line - straight(0.5 * (from + to))));
  }
  EXPECT_LT(missed, 0.02);
}

// A body that falls has no load at all.
TEST(Sampling, OfABodyWithoutJoints) {
  const Motion motion = simulate(testing::free_body(), at_peaks(1.0, 5));
  EXPECT_EQ(motion.instants.size(), 5u);
  EXPECT_TRUE(motion.repeats.empty());
}

// A smooth motion keeps its instants but for the maxima between them.
TEST(Sampling, OfASmoothDrivenMotion) {
  MechanismDefinition m = driven_into_a_spring();
  m.elements.clear();
  const Motion motion = simulate(m, at_peaks(1.0, 102));
  EXPECT_LT(motion.instants.size(), 108u);
  double largest = 0.0;
  for (const Instant& i : motion.instants) {
    largest = std::max(largest, std::abs(i.drives[0].effort));
  }
  EXPECT_NEAR(largest, 0.1 * 4.0 * M_PI * M_PI, 1e-6);
}

// A drive that starts with a jump in acceleration: both sides are there.
TEST(Sampling, BothSidesOfADrivesBend) {
  MechanismDefinition m = driven_into_a_spring();
  m.elements.clear();
  DriveDefinition& drive = m.drives[0];
  drive.law = DriveLaw::kTable;
  drive.table = numerics::interpolating_spline({0.0, 1.0, 2.0}, {0.0, 0.1, 0.0},
                                               numerics::SplineEnds::kClamped);
  drive.start = 0.35;
  const Motion motion = simulate(m, at_peaks(3.0, 31));
  const auto next = std::ranges::find_if(motion.instants, [](const Instant& i) {
    return i.t > 0.35;
  });
  EXPECT_NEAR((next - 1)->drives[0].effort, 0.0, 1e-9);
  EXPECT_GT(std::abs(next->drives[0].effort), 0.1);
  EXPECT_LT(next->t - (next - 1)->t, 2e-8);
}

// A part may feel a softer impact at a place, or beside loads, where the
// hardest means nothing to it.
TEST(Sampling, WithinSofterImpacts) {
  MechanismDefinition m = testing::sliders({1.0});
  m.elements = {
      testing::on_joint(
          0, StopLaw{.lower = 0.0,
                     .upper = {},
                     .contact = {.stiffness = 1e5, .damping = 200.0}}),
      testing::on_joint(0, TableLaw{.times = {0.0}, .efforts = {-5.0}})};
  m.initial_joints = {
      {.joint = 0, .position = 0.1, .rate = -1.0, .place = "start"}};
  const Motion motion = simulate(m, at_peaks(0.4, 4));
  ASSERT_GE(motion.impacts.size(), 2u);
  ASSERT_LT(motion.impacts[1].peak_force, 0.5 * motion.impacts[0].peak_force);
  for (const std::size_t i : {0U, 1U}) {
    const Impact& impact = motion.impacts[i];
    ASSERT_TRUE(impact.duration);
    double largest = 0.0;
    int within = 0;
    for (const Instant& at : motion.instants) {
      if (at.t <= impact.t || at.t >= impact.t + *impact.duration) continue;
      ++within;
      largest = std::max(largest, std::abs(at.elements[0].effort));
    }
    EXPECT_GE(within, 7) << i;
    EXPECT_NEAR(largest, impact.peak_force, 1e-3 * impact.peak_force) << i;
  }
}

// Between two instants a seat runs along a part.
TEST(Sampling, AlongASlideThatMovesForAMoment) {
  MechanismDefinition m = testing::sliders({1.0});
  DriveDefinition drive;
  drive.joint = 0;
  drive.law = DriveLaw::kRamp;
  drive.to = 0.1;
  drive.start = 5.005;
  drive.duration = 0.04;
  m.drives = {drive};
  const auto longest_way = [&](const SimulationSettings& settings) {
    const auto instants = simulate(m, settings).instants;
    double longest = 0.0;
    for (std::size_t i = 1; i < instants.size(); ++i) {
      longest = std::max(
          longest,
          (instants[i].joints[0].p_WJ - instants[i - 1].joints[0].p_WJ).norm());
    }
    return longest;
  };
  SimulationSettings settings = at_peaks(10.0, 201);
  EXPECT_GT(longest_way(settings), 0.01);
  settings.slides = {0};
  EXPECT_LT(longest_way(settings), 0.1 / 60.0);
  drive = {};
  drive.joint = 0;
  drive.law = DriveLaw::kSine;
  drive.amplitude = 0.1;
  drive.frequency = 10.0;  // in the middle at every instant
  m.drives = {drive};
  SimulationSettings turns = at_peaks(1.0, 21);
  turns.slides = {0};
  EXPECT_LT(longest_way(turns), 0.2 / 40.0);
  EXPECT_GT(longest_way(turns), 0.2 / 200.0);
  m.drives.clear();
  m.elements = {testing::on_joint(
      0, TableLaw{.times = {0.0, 5.0, 5.0, 5.001, 5.001},
                  .efforts = {0.0, 0.0, 1000.0, 1000.0, 0.0}})};
  EXPECT_LT(longest_way(settings), 5.0 / 60.0);  // 1 m/s for 5 s
}

// The way counts on the body that carries the slide, which may turn: 63 mm of a
// metre in a quarter of a turn.
TEST(SlideTimes, FollowTheWayOnAMovingBody) {
  MechanismDefinition m;
  m.joints.emplace_back().body_a = 0;
  const auto instant_at = [](double t, double along) {
    Instant instant;
    instant.t = t;
    part::Pose& pose = instant.bodies.emplace_back().pose;
    pose.R_WL =
        Eigen::AngleAxisd(0.5 * std::numbers::pi * t, Eigen::Vector3d::UnitZ())
            .toRotationMatrix();
    pose.p_WL = {10.0 * t, 0.0, 0.0};
    instant.joints.emplace_back().p_WJ =
        pose.p_WL + pose.R_WL * Eigen::Vector3d(along, 0.0, 0.0);
    return instant;
  };
  EXPECT_TRUE(slide_times(m, {0}, {instant_at(0.0, 0.3), instant_at(1.0, 0.3)})
                  .empty());
  const auto times = slide_times(
      m, {0},
      {instant_at(0.0, 0.0), instant_at(1.0, 0.0624), instant_at(2.0, 1.0)});
  EXPECT_EQ(std::ranges::count_if(times,
                                  [](double t) {
                                    return t < 1.0;
                                  }),
            3);
  EXPECT_EQ(times.size(), 63U);  // in 64ths, four of them before
}

}  // namespace
}  // namespace clevis::mechanism
