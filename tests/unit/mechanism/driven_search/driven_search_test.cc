// Loads of motions that drives fix are found when they act, however few the
// instants: against closed forms.
#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "mechanism/simulate.h"
#include "support/off_cubic.h"
#include "support/reference_motions.h"

namespace clevis::mechanism {
namespace {

SimulationSettings at_peaks(double duration, int instants) {
  SimulationSettings s;
  s.duration = duration;
  s.instants = instants;
  s.at_peaks = true;
  return s;
}

double largest(const Motion& motion,
               const std::function<double(const Instant&)>& value) {
  double most = 0.0;
  for (const Instant& i : motion.instants) {
    most = std::max(most, std::abs(value(i)));
  }
  return most;
}

double drive_effort(const Instant& instant) {
  return instant.drives[0].effort;
}

double element_effort(const Instant& instant) {
  return instant.elements[0].effort;
}

/// Slider of 1 kg at rest.
MechanismDefinition held_slider(DriveLaw law) {
  MechanismDefinition m = testing::sliders({1.0});
  m.drives = {{.joint = 0, .law = law, .place = "drive"}};
  return m;
}

// A pulse of 1 ms between two of 201 instants, and of 10 us.
TEST(DrivenSearch, PulseOfAForceTable) {
  for (const double width : {1e-3, 1e-5}) {
    MechanismDefinition m = held_slider(DriveLaw::kConstant);
    const double at = 0.4536;
    m.elements = {testing::on_joint(
        0, TableLaw{.times = {at - width / 2.0, at, at + width / 2.0},
                    .efforts = {0.0, 800.0, 0.0}})};
    for (const int instants : {2, 11, 201}) {
      const Motion motion = simulate(m, at_peaks(1.0, instants));
      EXPECT_NEAR(largest(motion, drive_effort), 800.0, 1e-9);
      EXPECT_FALSE(motion.search->ended);
    }
  }
}

// Steps: the force is there at once and until the end of each.
TEST(DrivenSearch, StepsOfAForceTable) {
  MechanismDefinition m = held_slider(DriveLaw::kConstant);
  m.elements = {
      testing::on_joint(0, TableLaw{.times = {0.3, 0.3, 0.3004, 0.3004},
                                    .efforts = {10.0, 500.0, 700.0, -20.0}})};
  const Motion motion = simulate(m, at_peaks(1.0, 12));
  EXPECT_NEAR(largest(motion, element_effort), 700.0, 1e-2);
  const auto at = [&](double t) {
    const auto next = std::ranges::find_if(motion.instants, [&](const auto& i) {
      return i.t > t;
    });
    return std::pair{(next - 1)->elements[0].effort, next->elements[0].effort};
  };
  EXPECT_NEAR(at(0.3).first, 10.0, 1e-9);
  EXPECT_NEAR(at(0.3).second, 500.0, 1e-2);
  EXPECT_NEAR(at(0.3004).second, -20.0, 1e-9);
}

// Instants at the zeros of a sine see nothing of its acceleration.
TEST(DrivenSearch, SineBetweenItsZeros) {
  MechanismDefinition m = held_slider(DriveLaw::kSine);
  m.drives[0].amplitude = 0.02;
  m.drives[0].frequency = 10.0;
  const double omega = 20.0 * M_PI;
  for (const int instants : {2, 5, 11, 15, 16, 21}) {
    const Motion motion = simulate(m, at_peaks(1.0, instants));
    EXPECT_NEAR(largest(motion, drive_effort), 0.02 * omega * omega, 1e-5);
  }
}

// Two sines that beat: 50 Hz and 51 Hz meet at 0.5 s of 1 s.
TEST(DrivenSearch, TwoDrivesThatBeat) {
  MechanismDefinition m = testing::sliders({1.0, 1.0});
  m.drives.clear();
  for (const double frequency : {50.0, 51.0}) {
    DriveDefinition drive;
    drive.joint = static_cast<int>(m.drives.size());
    drive.law = DriveLaw::kSine;
    drive.amplitude = 0.001;
    drive.frequency = frequency;
    m.drives.push_back(drive);
  }
  LineElement spring = testing::on_joint(0, SpringLaw{.stiffness = 1e6});
  spring.line = {};
  spring.line.kind = ElementLine::Kind::kSlide;
  spring.line.a.body = 0;
  spring.line.b.body = 1;
  m.elements = {spring};
  // of 2 mm cos(101 pi t) sin(pi t), by a fine search of the closed form
  double most = 0.0;
  for (int i = 0; i <= 2'000'000; ++i) {
    const double t = i / 2e6;
    most = std::max(most, 1e6 * 0.001 *
                              std::abs(std::sin(102.0 * M_PI * t) -
                                       std::sin(100.0 * M_PI * t)));
  }
  const Motion motion = simulate(m, at_peaks(1.0, 11));
  EXPECT_NEAR(largest(motion, element_effort), most, 1e-4 * most);
}

// A quintic of 2 ms within 10 s: 10/sqrt(3) stroke / duration^2.
TEST(DrivenSearch, QuickQuintic) {
  MechanismDefinition m = held_slider(DriveLaw::kQuintic);
  m.drives[0].to = 0.01;
  m.drives[0].start = 3.3333;
  m.drives[0].duration = 2e-3;
  const Motion motion = simulate(m, at_peaks(10.0, 2));
  const double peak = 10.0 / std::sqrt(3.0) * 0.01 / 4e-6;
  EXPECT_NEAR(largest(motion, drive_effort), peak, 1e-4 * peak);
}

/// Crank of 0.1 m that turns at a constant rate; a ball of 5 mm at its end.
MechanismDefinition turning_crank(double rate) {
  MechanismDefinition m;
  BodyDefinition crank =
      testing::uniform_bar("crank", Eigen::Vector3d::Zero(), 0.0, 0.1);
  m.bodies = {crank};
  JointDefinition hinge;
  hinge.name = "hinge";
  hinge.type = JointType::kRevolute;
  hinge.body_a = kGround;
  hinge.body_b = 0;
  hinge.place = "joint";
  m.joints = {hinge};
  DriveDefinition drive;
  drive.joint = 0;
  drive.law = DriveLaw::kSpeed;
  drive.speed = rate;
  m.drives = {drive};
  return m;
}

/// A plate that the ball dips into by `depth` where the crank stands upright.
ContactElement plate_above(double depth, double stiffness) {
  ContactElement contact;
  contact.name = "plate";
  contact.center.body = 0;
  contact.center.p_L = {0.1, 0.0, 0.0};
  contact.radius = 0.005;
  contact.plane.p_L = {0.0, 0.105 - depth, 0.0};
  contact.normal_L = -Eigen::Vector3d::UnitY();
  contact.law.stiffness = stiffness;
  return contact;
}

// Ten turns, the ball dips 0.1 mm, 1 um and 10 nm deep into a plate.
TEST(DrivenSearch, ContactOncePerTurn) {
  for (const double depth : {1e-4, 1e-6, 1e-8}) {
    MechanismDefinition m = turning_crank(20.0 * M_PI);
    m.elements = {plate_above(depth, 1e8)};
    for (const int instants : {2, 11, 201, 1001}) {
      const Motion motion = simulate(m, at_peaks(1.0, instants));
      EXPECT_NEAR(largest(motion, element_effort), 1e8 * depth,
                  1e-3 * 1e8 * depth)
          << depth << " m, " << instants;
      EXPECT_EQ(motion.events.size(), 20u) << depth << " m, " << instants;
      // cos(angle) = 1 - depth / r
      const double half = std::acos(1.0 - depth / 0.1) / (20.0 * M_PI);
      EXPECT_NEAR(motion.events[0].t, 0.025 - half, 2e-8);
      EXPECT_EQ(motion.events[0].what, "press");
      EXPECT_NEAR(motion.events[1].t, 0.025 + half, 2e-8);
      EXPECT_EQ(motion.events[1].what, "release");
    }
  }
}

// A ball that stays 10 nm away touches nothing.
TEST(DrivenSearch, NearMiss) {
  MechanismDefinition m = turning_crank(20.0 * M_PI);
  m.elements = {plate_above(-1e-8, 1e8)};
  const Motion motion = simulate(m, at_peaks(1.0, 11));
  EXPECT_EQ(largest(motion, element_effort), 0.0);
  EXPECT_TRUE(motion.events.empty());
}

// A cam as a table over the angle: 300 N within 0.2 deg of 77 deg.
TEST(DrivenSearch, SharpTableOverPositions) {
  constexpr double kDegree = M_PI / 180.0;
  MechanismDefinition m = turning_crank(2.0 * M_PI);
  m.elements = {testing::on_joint(
      0,
      TableLaw{.times = {},
               .efforts = {0.0, 300.0, 0.0},
               .positions = {76.9 * kDegree, 77.0 * kDegree, 77.1 * kDegree}})};
  for (const int instants : {2, 11, 201}) {
    const Motion motion = simulate(m, at_peaks(1.0, instants));
    EXPECT_NEAR(largest(motion, element_effort), 300.0, 1e-6);
  }
}

// The same passed there and back by a sine that just reaches its top.
TEST(DrivenSearch, TableTouchedWhereTheDriveTurnsBack) {
  MechanismDefinition m = held_slider(DriveLaw::kSine);
  m.drives[0].amplitude = 0.1;
  m.drives[0].frequency = 1.0;
  m.elements = {testing::on_joint(
      0, TableLaw{.times = {},
                  .efforts = {0.0, 0.0, 300.0, 0.0},
                  .positions = {0.0, 0.09998, 0.09999, 0.1}})};
  for (const int instants : {2, 3, 11, 201}) {
    const Motion motion = simulate(m, at_peaks(1.0, instants));
    EXPECT_NEAR(largest(motion, element_effort), 300.0, 1e-2);
  }
}

// Dry friction turns with the slider: both sides of each turn are instants.
TEST(DrivenSearch, FrictionTurns) {
  MechanismDefinition m = held_slider(DriveLaw::kSine);
  m.drives[0].amplitude = 0.1;
  m.drives[0].frequency = 1.0;
  m.elements = {
      testing::on_joint(0, FrictionLaw{.breakaway = 5.0, .kinetic = 5.0})};
  const Motion motion = simulate(m, at_peaks(1.0, 12));
  ASSERT_EQ(motion.events.size(), 2u);
  EXPECT_NEAR(motion.events[0].t, 0.25, 1e-8);
  EXPECT_NEAR(motion.events[1].t, 0.75, 1e-8);
  // inertia and friction at 0.25 s from below: -0.1 w^2 + 5
  const double inertia = 0.1 * 4.0 * M_PI * M_PI;
  const auto next = std::ranges::find_if(motion.instants, [](const auto& i) {
    return i.t > 0.25 + 1e-9;
  });
  EXPECT_NEAR(next->drives[0].effort, -inertia - 5.0, 1e-5);
  EXPECT_NEAR(largest(motion, drive_effort), inertia + 5.0, 1e-5);
}

// A rotor that merely spins with an imbalance asks for no instants more.
TEST(DrivenSearch, SpinningPartNeedsNoInstants) {
  const Motion motion =
      simulate(turning_crank(200.0 * M_PI), at_peaks(1.0, 21));
  EXPECT_LT(motion.instants.size(), 30u);
  EXPECT_FALSE(motion.search->ended);
  EXPECT_LT(motion.search->bodies[0], 1e-6);
}

// Under gravity its load turns: near the centrifugal force, once a turn.
TEST(DrivenSearch, LoadsBetweenInstantsAreOnTheirLine) {
  MechanismDefinition m = turning_crank(4.0 * M_PI);
  m.gravity_W = {0.0, -9.81, 0.0};
  const Motion motion = simulate(m, at_peaks(1.0, 2));
  EXPECT_LT(motion.search->bodies[0], 1.5e-3);  // what is allowed
  const double mass = m.bodies[0].mass_properties.mass;
  const double arm = m.bodies[0].mass_properties.p_LCm.norm();
  const double omega = 4.0 * M_PI;
  EXPECT_NEAR(largest(motion,
                      [](const Instant& i) {
                        return i.joints[0].f_W.norm();
                      }),
              mass * (arm * omega * omega + 9.81), 1e-4 * mass);
}

// 240 cycles of a sine: behind the first ones loads only repeat, and need no
// instants; what vibrates needs all of them.
TEST(DrivenSearch, LoadsThatRepeatAreFollowed) {
  MechanismDefinition m = held_slider(DriveLaw::kSine);
  m.drives[0].amplitude = 1e-5;
  m.drives[0].frequency = 160.0;
  const double omega = 320.0 * M_PI, most = 1e-5 * omega * omega;
  const Motion motion = simulate(m, at_peaks(1.5, 11));
  EXPECT_LT(motion.instants.size(), 1500u);
  ASSERT_GT(motion.repeats.size(), 1000u);
  const double until = std::min(1.5, motion.followed_until);
  EXPECT_GT(until, 0.5);
  const double missed =
      testing::off_cubic(motion, until, drive_effort, [&](double t) {
        return -most * std::sin(omega * t);
      });
  EXPECT_LT(missed, 1e-3 * most);
}

// A jerk, and a sine of a fiftieth of its load behind it.
TEST(DrivenSearch, SmallLoadsAreFollowed) {
  constexpr double kJerk = 1e-3, kSoon = 0.01, kSine = 0.02;
  constexpr double kDuration = 0.4, kStep = 2e-4;
  const double omega = 320.0 * M_PI;
  const double most = 2.0 * kJerk / (kSoon * kSoon);
  std::vector<double> times, positions;
  for (int i = 0; i * kStep <= kDuration; ++i) {
    const double t = i * kStep;
    times.push_back(t);
    positions.push_back(kJerk * std::exp(-t * t / (kSoon * kSoon)) +
                        kSine * most / (omega * omega) * std::cos(omega * t));
  }
  MechanismDefinition m = held_slider(DriveLaw::kTable);
  m.drives[0].table = numerics::interpolating_spline(
      times, positions, numerics::SplineEnds::kClamped);
  const Motion motion = simulate(m, at_peaks(kDuration - kStep, 3));
  EXPECT_NEAR(largest(motion, drive_effort), (1.0 + kSine) * most, 0.01 * most);
  const double missed = testing::off_cubic(
      motion, motion.followed_until, drive_effort, [&](double t) {
        const double s = t / kSoon;
        return -most * ((1.0 - 2.0 * s * s) * std::exp(-s * s) +
                        kSine * std::cos(omega * t));
      });
  EXPECT_LT(missed, 0.05 * kSine * most);
}

// Loads that never repeat leave nothing apart.
TEST(DrivenSearch, FewInstantsLeaveNothingApart) {
  const Motion motion =
      simulate(held_slider(DriveLaw::kConstant), at_peaks(1.0, 11));
  EXPECT_TRUE(motion.repeats.empty());
  EXPECT_GE(motion.followed_until, 1.0);
}

}  // namespace
}  // namespace clevis::mechanism
