#include "mechanism/events/stick_slip.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "mechanism/mass_matrix/centre_frame.h"
#include "support/reference_motions.h"

namespace clevis::mechanism {
namespace {

using Eigen::VectorXd;

constexpr double kMass = 2.0;  // kg

FrictionLaw friction(double breakaway, double kinetic) {
  FrictionLaw law;
  law.breakaway = breakaway;
  law.kinetic = kinetic;
  return law;
}

/// Sliders along x, the first pushed by a force.
MechanismDefinition pushed(std::size_t count, double push) {
  MechanismDefinition m = testing::sliders(std::vector<double>(count, kMass));
  ConstantForce force;
  force.point.body = 0;
  force.f_W = {push, 0.0, 0.0};
  m.elements = {force};
  return m;
}

/// A mechanism in a state, its modes chosen.
struct Chosen {
  explicit Chosen(const MechanismDefinition& m, double speed = 0.0)
      : definition(m),
        frame(frame_at_centres(definition)),
        dynamics(definition, frame, 1e-8, 1.0),
        equations(dynamics.equations()),
        y(equations.start(frame.placement)),
        rate(VectorXd::Zero(dynamics.size())) {
    y[equations.layout().velocity_index()] = speed;
    dynamics.projection().project(0.0, y);
    dynamics.note_speed(y);
    StickSlip(dynamics).choose_modes(0.0, y);
    dynamics.rate(0.0, y, rate);
  }

  int mode(std::size_t k) const {
    return equations.forces().element(k).modes[0];
  }
  double effort(std::size_t k) const {
    return equations.state().loads.forces.elements[k].effort;
  }
  /// Of the first slider [m/s²].
  double acceleration() const {
    return rate[equations.layout().velocity_index()];
  }

  MechanismDefinition definition;
  SolvingFrame frame;
  ForwardDynamics dynamics;
  EquationsOfMotion& equations;
  VectorXd y, rate;
};

// At rest friction gives what holds the line, up to its breakaway; beyond that
// the line slips against its kinetic friction.
TEST(StickSlip, HoldsUpToBreakawayThenSlips) {
  for (const double sense : {-1.0, 1.0}) {
    for (const double push : {0.0, 1.5, 2.999, 3.001, 8.0}) {
      MechanismDefinition m = pushed(1, sense * push);
      m.elements.emplace_back(testing::on_joint(0, friction(3.0, 2.0)));
      const Chosen chosen(m);
      const bool slips = push > 3.0;
      EXPECT_EQ(chosen.mode(1), slips ? static_cast<int>(sense) : 0) << push;
      EXPECT_NEAR(chosen.effort(1), -sense * (slips ? 2.0 : push), 1e-12);
      EXPECT_NEAR(chosen.acceleration(),
                  slips ? sense * (push - 2.0) / kMass : 0.0, 1e-12);
    }
  }
}

TEST(StickSlip, MovingLinesSlipInTheirSense) {
  for (const double speed : {-0.3, 0.3}) {
    MechanismDefinition m = pushed(1, 1.0);
    m.elements.emplace_back(testing::on_joint(0, friction(3.0, 2.0)));
    const Chosen chosen(m, speed);
    EXPECT_EQ(chosen.mode(1), speed > 0.0 ? 1 : -1);
    EXPECT_NEAR(chosen.acceleration(),
                (1.0 - std::copysign(2.0, speed)) / kMass, 1e-12);
  }
}

// Two frictions of one line hold up to their sum, whatever their shares, each
// no more than its own breakaway.
TEST(StickSlip, SeveralFrictionsOfALineHoldTogether) {
  for (const double push : {0.5, 3.9, 4.1}) {
    MechanismDefinition m = pushed(1, push);
    m.elements.emplace_back(testing::on_joint(0, friction(1.0, 0.8)));
    m.elements.emplace_back(testing::on_joint(0, friction(3.0, 2.5)));
    const Chosen chosen(m);
    if (push < 4.0) {
      EXPECT_NEAR(chosen.acceleration(), 0.0, 1e-12) << push;
      EXPECT_NEAR(chosen.effort(1) + chosen.effort(2), -push, 1e-12);
      EXPECT_LE(std::abs(chosen.effort(1)), 1.0 + 1e-12);
      EXPECT_LE(std::abs(chosen.effort(2)), 3.0 + 1e-12);
    } else {
      EXPECT_NEAR(chosen.acceleration(), (push - 3.3) / kMass, 1e-12);
      EXPECT_EQ(chosen.mode(1), 1);
      EXPECT_EQ(chosen.mode(2), 1);
    }
  }
}

/// Two sliders, the second carried by friction on the first.
MechanismDefinition carried(double push, double breakaway, double kinetic) {
  MechanismDefinition m = pushed(2, push);
  LineElement sole;
  sole.name = "sole";
  sole.line.kind = ElementLine::Kind::kSlide;
  sole.line.a.body = 0;
  sole.line.b.body = 1;
  sole.law = friction(breakaway, kinetic);
  m.elements.emplace_back(sole);
  return m;
}

// The second is carried along as long as friction can accelerate it; then each
// goes its own way.
TEST(StickSlip, CarriesAsFarAsFrictionCan) {
  const Chosen together(carried(5.0, 3.0, 2.0));
  EXPECT_EQ(together.mode(1), 0);
  EXPECT_NEAR(together.acceleration(), 5.0 / (2.0 * kMass), 1e-12);
  EXPECT_NEAR(std::abs(together.effort(1)), 2.5, 1e-12);
  const Chosen apart(carried(7.0, 3.0, 2.0));
  EXPECT_EQ(std::abs(apart.mode(1)), 1);
  EXPECT_NEAR(apart.acceleration(), (7.0 - 2.0) / kMass, 1e-12);
}

// No step may leap over the peak of friction at low speed.
TEST(StickSlip, FirstStepResolvesStribecksZone) {
  MechanismDefinition m = pushed(1, 8.0);
  FrictionLaw law = friction(3.0, 2.0);
  law.stribeck_speed = 1e-4;
  m.elements.emplace_back(testing::on_joint(0, law));
  Chosen chosen(m, 1e-5);
  const double step = StickSlip(chosen.dynamics).first_step(0.0, chosen.y);
  const double through = 6.0 * law.stribeck_speed / chosen.acceleration();
  EXPECT_GT(step, 0.0);
  EXPECT_LT(step, 0.1 * through);
}

}  // namespace
}  // namespace clevis::mechanism
