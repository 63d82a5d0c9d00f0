// Dry friction of a slider whose crank runs through its dead centres: there
// the slider rests for an instant, and the crank carries it on.
#include <cmath>

#include <gtest/gtest.h>

#include "mechanism/events/stick_slip.h"
#include "mechanism/forces/element_modes.h"
#include "mechanism/mass_matrix/centre_frame.h"
#include "mechanism/simulate.h"
#include "support/reference_motions.h"

namespace clevis::mechanism {
namespace {

using Eigen::Vector3d;
using testing::on_joint;

constexpr double kCrank = 0.1, kRod = 0.3, kInertia = 0.01, kG = 9.81;

/// Crank (pin O), rod and slider along x, 1 kg each, their centres in the
/// middle, the slider's at its pin.
MechanismDefinition slider_crank(double angle, double rate, double gravity) {
  MechanismDefinition m;
  const double lean = -std::asin(kCrank * std::sin(angle) / kRod);
  const Vector3d pin(kCrank * std::cos(angle), kCrank * std::sin(angle), 0.0);
  const auto body = [&](const Vector3d& p, double turn, double length) {
    BodyDefinition b = testing::uniform_bar("body", p, turn, 1.0);
    b.mass_properties.mass = 1.0;
    b.mass_properties.p_LCm = {0.5 * length, 0.0, 0.0};
    b.mass_properties.inertia_LCm = kInertia * Eigen::Matrix3d::Identity();
    m.bodies.push_back(b);
  };
  body(Vector3d::Zero(), angle, kCrank);
  body(pin, lean, kRod);
  body({pin.x() + kRod * std::cos(lean), 0.0, 0.0}, 0.0, 0.0);
  m.joints = {testing::pin("O", kGround, 0, 0.0, 0.0),
              testing::pin("P", 0, 1, kCrank, 0.0),
              testing::pin("Q", 1, 2, kRod, 0.0),
              {.name = "S",
               .type = JointType::kPrismatic,
               .body_a = kGround,
               .body_b = 2,
               .frame_a = testing::slide(1.0),
               .frame_b = testing::slide(1.0),
               .place = "S"}};
  m.gravity_W = {0.0, -gravity, 0.0};
  m.initial_joints = {
      {.joint = 0, .position = angle, .rate = rate, .place = "initial"}};
  return m;
}

double slider_at(double angle) {
  const double s = kCrank * std::sin(angle);
  return kCrank * std::cos(angle) + std::sqrt(kRod * kRod - s * s);
}

/// Mass of all, reduced to the crank's angle [kg m²].
double reduced_inertia(double angle) {
  const double s = std::sin(angle), c = std::cos(angle);
  const double rod_x = std::sqrt(kRod * kRod - kCrank * kCrank * s * s);
  const double lean_rate = -kCrank * c / rod_x;
  const double slider = -kCrank * s + kCrank * kCrank * -s * c / rod_x;
  const double rod_cx = 0.5 * (-kCrank * s + slider), rod_cy = 0.5 * kCrank * c;
  return kInertia + 0.25 * kCrank * kCrank + kInertia * lean_rate * lean_rate +
         rod_cx * rod_cx + rod_cy * rod_cy + slider * slider;
}

double potential(double angle) {
  return kG * kCrank * std::sin(angle);  // ½ of the crank, ½ of the rod
}

/// Way of the slider from the outer dead centre, both ways counted.
double way(double angle) {
  const double half_turns = std::floor(angle / M_PI);
  const double from = slider_at(half_turns * M_PI);
  return half_turns * 2.0 * kCrank + std::abs(slider_at(angle) - from);
}

SimulationSettings settings(double duration, double tolerance) {
  SimulationSettings s;
  s.duration = duration;
  s.instants = 101;
  s.tolerance = tolerance;
  return s;
}

/// Rate of the crank at an angle from its energy and the way of the slider.
double exact_rate(double angle, double start, double rate, double friction,
                  bool falls) {
  const double energy = 0.5 * reduced_inertia(start) * rate * rate +
                        (falls ? potential(start) - potential(angle) : 0.0) -
                        friction * (way(angle) - way(start));
  return std::sqrt(2.0 * energy / reduced_inertia(angle));
}

class DeadCentre : public ::testing::TestWithParam<double> {};

TEST_P(DeadCentre, CoulombSliderTurnsAndTheCrankGoesOn) {
  const double tolerance = GetParam();
  constexpr double friction = 4.0, rate = 30.0;
  for (const double start : {0.0, 0.7}) {
    for (const bool falls : {false, true}) {
      MechanismDefinition m = slider_crank(start, rate, falls ? kG : 0.0);
      FrictionLaw law;
      law.kinetic = law.breakaway = friction;
      m.elements = {on_joint(3, law)};
      const Motion motion = simulate(m, settings(1.0, tolerance));
      double angle = start;
      for (const Instant& at : motion.instants) {
        const Eigen::Matrix3d& R = at.bodies[0].pose.R_WL;
        const double turned = std::atan2(R(1, 0), R(0, 0));
        angle += std::remainder(turned - angle, 2.0 * M_PI);
        EXPECT_NEAR(at.bodies[0].w_WL.z(),
                    exact_rate(angle, start, rate, friction, falls),
                    rate * (5.0 * tolerance + 1e-9))
            << tolerance << " " << at.t;
        EXPECT_LE(at.elements[0].power, 1e-9);
      }
      const auto turns = static_cast<std::size_t>(angle / M_PI);
      ASSERT_EQ(motion.events.size(), turns);
      for (const MotionEvent& event : motion.events) {
        EXPECT_EQ(event.what, "turn");
      }
      EXPECT_LT(motion.integration->relative_energy_error, tolerance + 1e-10);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Tolerances, DeadCentre,
                         ::testing::Values(1e-3, 1e-4, 1e-6, 1e-8, 1e-10));

// From rest at the dead centre under gravity: the slider does not move at
// first, yet holds nothing.
TEST(DeadCentreFriction, CrankFallsFromItsDeadCentre) {
  MechanismDefinition m = slider_crank(0.0, 0.0, kG);
  FrictionLaw law;
  law.kinetic = law.breakaway = 4.0;
  m.elements = {on_joint(3, law)};
  const Motion motion = simulate(m, settings(0.2, 1e-9));
  const Instant& end = motion.instants.back();
  const Eigen::Matrix3d& R = end.bodies[0].pose.R_WL;
  const double angle = std::atan2(R(1, 0), R(0, 0));
  EXPECT_LT(angle, -0.3);
  const double energy =
      -potential(angle) - 4.0 * (slider_at(0.0) - slider_at(angle));
  EXPECT_NEAR(end.bodies[0].w_WL.z(),
              -std::sqrt(2.0 * energy / reduced_inertia(angle)), 1e-7);
}

// Enough friction in two joints of the one freedom: each alone would not hold.
TEST(DeadCentreFriction, SeveralJointsHoldTogether) {
  for (const double part : {0.55, 0.45}) {
    MechanismDefinition m = slider_crank(0.0, 0.0, kG);
    FrictionLaw law;
    law.kinetic = law.breakaway = part * kG * kCrank;
    m.elements = {on_joint(0, law), on_joint(0, law)};
    const Motion motion = simulate(m, settings(0.5, 1e-8));
    const bool holds = part > 0.5;
    EXPECT_EQ(std::abs(motion.instants.back().bodies[0].w_WL.z()) < 1e-12,
              holds);
  }
}

// Friction that follows reactions, which friction at rest leaves open.
TEST(DeadCentreFriction, JointsThatHoldTogetherNeedNoUniqueReactions) {
  MechanismDefinition m = slider_crank(0.7, 0.0, kG);
  FrictionLaw law;
  law.follows_reaction = true;
  law.kinetic = law.breakaway = 0.8 * 0.2;
  m.elements = {on_joint(0, law), on_joint(1, law), on_joint(2, law)};
  const Motion motion = simulate(m, settings(0.5, 1e-8));
  const Instant& end = motion.instants.back();
  EXPECT_LT(end.bodies[0].w_WL.norm(), 1e-12);
  EXPECT_FALSE(end.elements[0].unique);
}

/// A moment about the crank's pin that grows by 3 N m/s.
LineElement growing_moment() {
  TableLaw law;
  law.times = {0.0, 1.0};
  law.efforts = {0.0, 3.0};
  return on_joint(0, law);
}

// Truth: virtual work. Each line holds its breakaway times its lever.
TEST(DeadCentreFriction, LinesOfOneFreedomLetGoTogether) {
  for (const double degrees : {20.0, 75.0, 150.0, 175.0}) {
    for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
      const double angle = degrees * M_PI / 180.0, step = 1e-6;
      MechanismDefinition m = slider_crank(angle, 0.0, 0.0);
      const auto lean = [](double q) {
        return -std::asin(kCrank * std::sin(q) / kRod);
      };
      const auto slope = [&](const auto& f) {
        return std::abs(f(angle + step) - f(angle - step)) / (2.0 * step);
      };
      const double lean_slope = slope(lean);
      const bool opposite = std::cos(angle) > 0.0;  // the rod leans back
      const double levers[] = {1.0,
                               opposite ? 1.0 + lean_slope : 1.0 - lean_slope,
                               lean_slope, slope(slider_at)};
      const double most[] = {0.05, 0.05, 0.05, 2.0};
      double capacity = 0.0;
      for (int j = 0; j < 4; ++j) {
        FrictionLaw law;
        law.kinetic = law.breakaway = most[j];
        m.elements.emplace_back(on_joint(j, law));
        capacity += most[j] * std::abs(levers[j]);
      }
      m.elements.emplace_back(growing_moment());
      const Motion motion = simulate(m, settings(0.3, tolerance));
      ASSERT_FALSE(motion.events.empty()) << degrees;
      EXPECT_EQ(motion.events[0].what, "slip");
      EXPECT_NEAR(3.0 * motion.events[0].t, capacity, 1e-6)
          << degrees << " " << tolerance;
    }
  }
}

// At its dead centre the slider holds nothing.
TEST(DeadCentreFriction, SliderAtItsDeadCentreHoldsNothing) {
  for (const double tolerance : {1e-3, 1e-6, 1e-9}) {
    MechanismDefinition m = slider_crank(0.0, 0.0, 0.0);
    FrictionLaw pin, slider;
    pin.kinetic = pin.breakaway = 0.05;
    slider.kinetic = slider.breakaway = 2.0;
    m.elements = {on_joint(1, pin), on_joint(3, slider), growing_moment()};
    const Motion motion = simulate(m, settings(0.1, tolerance));
    ASSERT_FALSE(motion.events.empty());
    EXPECT_EQ(motion.events[0].element, 0);
    EXPECT_NEAR(3.0 * motion.events[0].t, 0.05 * (1.0 + kCrank / kRod), 1e-6);
    EXPECT_GT(motion.instants.back().bodies[0].w_WL.z(), 0.1);
  }
}

// Dry friction on the driven joint and on one that the drive carries: it rests
// until the drive starts, gently or not, and the drive pays for it.
TEST(DeadCentreFriction, DrivenJointsSlipWhenTheirDriveStarts) {
  for (const auto law : {DriveLaw::kQuintic, DriveLaw::kRamp}) {
    for (const double tolerance : {1e-4, 1e-8}) {
      MechanismDefinition m = slider_crank(0.7, 0.0, 0.0);
      m.initial_joints.clear();
      FrictionLaw friction;
      friction.kinetic = friction.breakaway = 0.4;
      m.elements = {on_joint(0, friction), on_joint(3, friction)};
      DriveDefinition drive;
      drive.joint = 0;
      drive.law = law;
      drive.from = 0.7;
      drive.to = 1.7;
      drive.start = 0.2;
      drive.duration = 0.5;
      m.drives = {drive};
      SimulationSettings s = settings(1.0, tolerance);
      s.motion = MotionKind::kDynamic;
      const Motion motion = simulate(m, s);
      const auto turned = [](const Instant& at) {
        const Eigen::Matrix3d& R = at.bodies[0].pose.R_WL;
        return std::atan2(R(1, 0), R(0, 0));
      };
      EXPECT_NEAR(turned(motion.instants[20]), 0.7, 1e-9);
      EXPECT_NEAR(turned(motion.instants[45]), 1.2, 1e-9);
      EXPECT_NEAR(turned(motion.instants[100]), 1.7, 1e-9);
      EXPECT_EQ(motion.instants[45].elements[0].effort, -0.4);
      EXPECT_EQ(motion.instants[45].elements[1].effort, 0.4);
      EXPECT_LT(motion.integration->relative_energy_error, tolerance);
    }
  }
}

// A peak of friction that is narrow in time is not stepped over.
TEST(DeadCentreFriction, NarrowStribeckPeakIsSeen) {
  const auto end = [](double tolerance) {
    MechanismDefinition m = testing::sliders({1.0});
    FrictionLaw law;
    law.kinetic = 1.0;
    law.breakaway = 3.0;
    law.stribeck_speed = 0.005;
    m.elements = {on_joint(0, SpringLaw{.stiffness = 100.0}), on_joint(0, law)};
    m.initial_joints = {
        {.joint = 0, .position = 0.3, .rate = 0.0, .place = "initial"}};
    return simulate(m, settings(3.0, tolerance))
        .instants.back()
        .bodies[0]
        .pose.p_WL.x();
  };
  const double exact = end(1e-12);
  for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
    EXPECT_NEAR(end(tolerance), exact, tolerance);
  }
}

// What ends a motion with K012.
TEST(DeadCentreFriction, LineAgainstItsModeIsFound) {
  MechanismDefinition m = testing::sliders({2.0});
  FrictionLaw law;
  law.kinetic = law.breakaway = 1.0;
  m.elements = {on_joint(0, law)};
  const SolvingFrame frame = frame_at_centres(m);
  ForwardDynamics dynamics(m, frame, 1e-8, 1.0);
  EquationsOfMotion& equations = dynamics.equations();
  Eigen::VectorXd y = equations.start(frame.placement);
  y[equations.layout().velocity_index()] = -0.3;
  StickSlip(dynamics).choose_modes(0.0, y);
  dynamics.note_speed(y);
  const ForceState& acting = equations.evaluate_forces(0.0, y).loads.forces;
  ForceModel& forces = equations.forces();
  EXPECT_EQ(forces.element(0).modes[0], -1);
  EXPECT_EQ(line_against_its_mode(forces, acting), 1u);  // none
  for (const int wrong : {0, 1}) {
    forces.element(0).modes[0] = wrong;
    EXPECT_EQ(line_against_its_mode(forces, acting), 0u) << wrong;
  }
}

}  // namespace
}  // namespace clevis::mechanism
