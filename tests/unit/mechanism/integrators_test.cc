#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "mechanism/simulate.h"
#include "numerics/integrators/collocation.h"
#include "numerics/integrators/dop853.h"
#include "numerics/integrators/radau.h"
#include "support/reference_motions.h"

namespace clevis::mechanism {
namespace {

using Eigen::VectorXd;

/// y' = λ y with an error allowed per step.
class Decay : public numerics::OdeSystem {
 public:
  Decay(double lambda, double tolerance)
      : lambda_(lambda), tolerance_(tolerance) {}
  int size() const override { return 1; }
  void rate(double /*t*/, const VectorXd& y, VectorXd& rate) override {
    rate = lambda_ * y;
  }
  void error_weights(const VectorXd& /*y*/, VectorXd& weights) const override {
    weights.setConstant(1.0 / tolerance_);
  }
  void scales(const VectorXd& /*y*/, VectorXd& scales) const override {
    scales.setOnes();
  }

 private:
  double lambda_, tolerance_;
};

/// Padé's approximation of e^z with degrees s − 1 over s.
double pade(int s, double z) {
  double above = 0.0, below = 0.0, term = 1.0, term_below = 1.0;
  for (int k = 0; k <= s; ++k) {
    if (k < s) above += term;
    below += term_below;
    term *= (s - 1.0 - k) / (2.0 * s - 1.0 - k) * z / (k + 1.0);
    term_below *= -(s - k) / (2.0 * s - 1.0 - k) * z / (k + 1.0);
  }
  return above / below;
}

// The stability function of Radau IIA is Padé's.
TEST(Collocation, IsRadauIIA) {
  EXPECT_NEAR(pade(3, -1.0), (1.0 - 0.4 + 0.05) / (1.6 + 0.15 + 1.0 / 60.0),
              1e-15);
  for (const int stages : {3, 5, 7}) {
    for (const double z : {-1e6, -30.0, -1.0, -0.1, 0.2}) {
      Decay decay(z, 1e-3);
      numerics::Collocation collocation(decay);
      collocation.use(numerics::radau_method(stages));
      VectorXd y = VectorXd::Ones(1), slope(1), weights(1);
      collocation.start(0.0, y, slope);
      weights.setConstant(1e13);
      collocation.linearise(0.0, y, slope, numerics::Collocation::Axes::kFixed);
      ASSERT_TRUE(collocation.factor(1.0));
      ASSERT_TRUE(collocation.solve(0.0, y, 1.0, weights)) << z;
      const numerics::Collocation::Stages& z_end = collocation.stages();
      EXPECT_NEAR(1.0 + z_end[collocation.method().count() - 1][0],
                  pade(stages, z), 1e-13)
          << stages << " " << z;
    }
  }
}

// The difference of the embedded formula, unfiltered: 0 for polynomials of the
// degree it is exact for, not for one more.
TEST(RadauMethod, ErrorIsOfItsOrder) {
  for (const int stages : {3, 5, 7}) {
    const numerics::RadauMethod& method = numerics::radau_method(stages);
    for (int degree = 1; degree <= stages + 1; ++degree) {
      double error = degree == 1 ? 1.0 : 0.0;  // the slope at the start
      for (std::size_t i = 0; i < method.count(); ++i) {
        error += method.error[i] * std::pow(method.c[i], degree);
      }
      if (degree <= stages) {
        EXPECT_NEAR(error, 0.0, 1e-11) << stages << " " << degree;
      } else {
        EXPECT_GT(std::abs(error), 1e-4) << stages;
      }
    }
  }
}

TEST(Radau, StateWithinAStepIsAsAccurateAsItsEnd) {
  Decay decay(-1.0, 1e-8);
  numerics::Radau radau(decay);
  VectorXd y = VectorXd::Ones(1);
  radau.restart(0.0, y, 0.0);
  double polynomial = 0.0, exact = 0.0;
  while (radau.t() < 1.0) {
    ASSERT_TRUE(radau.step(1.0));
    const double t = 0.5 * (radau.t_start() + radau.t());
    radau.interpolate(t, y);
    polynomial = std::max(polynomial, std::abs(y[0] - std::exp(-t)));
    radau.state_at(t, y);
    exact = std::max(exact, std::abs(y[0] - std::exp(-t)));
  }
  EXPECT_LT(exact, 1e-8);
  EXPECT_GT(polynomial, exact);
}

SimulationSettings settings(double duration, int instants, double tolerance,
                            numerics::IntegratorChoice choice) {
  SimulationSettings s;
  s.duration = duration;
  s.instants = instants;
  s.tolerance = tolerance;
  s.motion = MotionKind::kDynamic;
  s.integrator = choice;
  return s;
}

constexpr numerics::IntegratorChoice kChoices[] = {
    numerics::IntegratorChoice::kAuto, numerics::IntegratorChoice::kExplicit,
    numerics::IntegratorChoice::kImplicit};
constexpr double kTolerances[] = {1e-3, 1e-4, 1e-5, 1e-6, 1e-8, 1e-10};

/// Over six tolerances: the error is at most the one asked for times `size`,
/// never more than ten times the largest at coarser tolerances.
void expect_falling(const std::function<double(double)>& error, double size,
                    double digits) {
  double coarser = std::numeric_limits<double>::infinity();
  for (const double tolerance : kTolerances) {
    const double here = error(tolerance);
    EXPECT_LT(here, size * tolerance + digits) << tolerance;
    EXPECT_LT(here, 10.0 * coarser + digits) << tolerance;
    coarser = std::min(coarser, here);
  }
}

// Reference: converged to the digits shown.
TEST(Integrators, SpatialSliderCrank) {
  const double known[] = {0.226787189, 0.184952630, 0.211721661, 0.240719574};
  const std::size_t at[] = {1, 5, 10, 50};
  for (const numerics::IntegratorChoice choice :
       {numerics::IntegratorChoice::kAuto,
        numerics::IntegratorChoice::kImplicit}) {
    const auto error = [&](double tolerance) {
      const Motion motion = simulate(testing::spatial_slider_crank(),
                                     settings(5.0, 51, tolerance, choice));
      double worst = 0.0;
      for (std::size_t i = 0; i < 4; ++i) {
        const double x = motion.instants[at[i]].bodies[2].pose.p_WL.x();
        worst = std::max(worst, std::abs(x - known[i]));
      }
      EXPECT_LT(motion.instants[at[3]].closure_error, 1e-12);
      return worst;
    };
    for (const double tolerance : {1e-3, 1e-5, 1e-7}) {
      EXPECT_LT(error(tolerance), tolerance + 1e-9) << tolerance;
    }
  }
}

TEST(Integrators, TimesOfStickAndSlip) {
  for (const numerics::IntegratorChoice choice : kChoices) {
    expect_falling(
        [choice](double tolerance) {
          const Motion motion =
              simulate(testing::pulled({.breakaway = 1.5, .kinetic = 1.0}),
                       settings(25.0, 26, tolerance, choice));
          if (motion.events.size() < 3) return 1.0;
          const double slip = 2.611259254101;
          return std::max({std::abs(motion.events[0].t - 7.5),
                           std::abs(motion.events[1].t - 7.5 - slip),
                           std::abs(motion.events[2].t - 12.5 - slip)});
        },
        1.0, 1e-11);
  }
}

// Bristles of 1e5 N/m: the engine goes over to the implicit method and back.
TEST(Integrators, BristlesAreStiff) {
  long steps = 0;
  expect_falling(
      [&steps](double tolerance) {
        const Motion motion = simulate(
            testing::pulled(testing::bristles()),
            settings(25.0, 26, tolerance, numerics::IntegratorChoice::kAuto));
        const IntegrationSummary& run = *motion.integration;
        EXPECT_EQ(run.method, "DOP853 and Radau IIA");
        EXPECT_GT(run.implicit_steps, 0);
        steps = std::max(steps, run.steps);
        return std::abs(motion.instants.back().bodies[1].pose.p_WL.x() -
                        1.908839199);
      },
      1.0, 1e-9);
  EXPECT_LT(steps, 5000);  // DOP853 alone: 30 000
}

// Elastic wall of 1e8 N/m under a spring of 100 N/m: times of touch and
// release by halves of both periods.
TEST(Integrators, WallOf1e8) {
  for (const numerics::IntegratorChoice choice : kChoices) {
    expect_falling(
        [choice](double tolerance) {
          const Motion motion =
              simulate(testing::against_a_wall({.stiffness = 1e8}),
                       settings(3.0, 4, tolerance, choice));
          EXPECT_EQ(motion.events.size(), 20u);
          const double inside = M_PI / std::sqrt(1e8 + 100.0);
          double t = M_PI / 20.0, worst = 0.0;
          for (std::size_t k = 0; k + 1 < motion.events.size(); k += 2) {
            worst = std::max(worst, std::abs(motion.events[k].t - t));
            t += inside;
            worst = std::max(worst, std::abs(motion.events[k + 1].t - t));
            t += M_PI / 10.0;
          }
          return worst;
        },
        1.0, 1e-12);
  }
}

// 1 kg on 1e4 N/m in oil of 1e8 N s/m: x' = −(k/c) x but for 1e-8 s.
TEST(Integrators, StiffDamperTakesFewSteps) {
  MechanismDefinition m = testing::sliders({1.0});
  m.elements = {
      testing::on_joint(0, SpringLaw{.stiffness = 1e4, .damping = 1e8})};
  m.initial_joints = {
      {.joint = 0, .position = 0.1, .rate = {}, .place = "initial"}};
  const Motion motion =
      simulate(m, settings(1e4, 11, 1e-6, numerics::IntegratorChoice::kAuto));
  for (const Instant& i : motion.instants) {
    EXPECT_NEAR(i.bodies[0].pose.p_WL.x(), 0.1 * std::exp(-1e-4 * i.t), 1e-6);
  }
  EXPECT_LT(motion.integration->steps, 200);
  EXPECT_GT(motion.integration->implicit_steps, 10);
}

// At rest on a floor of 1e8 N/m for 1000 s; without friction it slides on.
TEST(Integrators, RestsOnAStiffFloorForLong) {
  MechanismDefinition m;
  BodyDefinition ball = testing::uniform_bar("ball", {0.0, 0.0, 0.1}, 0.0, 0.1);
  ball.mass_properties.p_LCm.setZero();
  m.bodies = {ball};
  m.gravity_W = {0.0, 0.0, -9.81};
  ContactElement contact;
  contact.center.body = 0;
  contact.radius = 0.1;
  contact.normal_L = Eigen::Vector3d::UnitZ();
  contact.law = {.stiffness = 1e8, .damping = 1e3};
  m.elements = {contact};
  InitialBodyState push;
  push.body = 0;
  push.v_WLo = {0.5, 0.0, 0.0};
  m.initial_bodies = {push};
  const Motion motion = simulate(
      m, settings(1000.0, 11, 1e-6, numerics::IntegratorChoice::kAuto));
  const Instant& end = motion.instants.back();
  EXPECT_NEAR(end.elements[0].effort, 9.81, 1e-4);
  EXPECT_NEAR(end.bodies[0].pose.p_WL.z(), 0.1 - 9.81e-8, 1e-9);
  EXPECT_NEAR(end.bodies[0].pose.p_WL.x(), 500.0, 1e-3);
  EXPECT_LT(motion.integration->steps, 2000);
}

// Pin of the pendulum: 3 m g at the bottom, between the instants.
TEST(ReactionPeaks, PendulumAtTheBottom) {
  SimulationSettings s =
      settings(1.0, 3, 1e-9, numerics::IntegratorChoice::kAuto);
  s.at_peaks = true;
  const Motion motion = simulate(testing::simple_pendulum(1.0), s);
  const auto bottom =
      std::ranges::max_element(motion.instants, {}, [](const Instant& i) {
        return i.joints[0].f_W.norm();
      });
  // a quarter of the period
  EXPECT_NEAR(bottom->t, 0.25 * 2.367841947576237, 1e-5);
  EXPECT_NEAR(bottom->joints[0].f_W.norm(), 29.43, 1e-7);
}

// Lever that hits a stop of 1e6 N m/rad: the blow of 3 ms is not missed. With
// Ω² = k/I and impact speed w: M = I Ω w, pin against it m l/2 Ω w.
TEST(ReactionPeaks, BlowBetweenInstants) {
  MechanismDefinition m;
  m.bodies = {testing::uniform_bar("lever", {0.0, 0.0, 0.0}, 0.0, 1.0)};
  m.joints = {testing::pin("O", kGround, 0, 0.0, 0.0)};
  m.elements = {testing::on_joint(
      0, StopLaw{.lower = {}, .upper = 0.5, .contact = {.stiffness = 1e6}})};
  m.initial_joints = {
      {.joint = 0, .position = {}, .rate = 1.0, .place = "initial"}};
  SimulationSettings s =
      settings(1.0, 11, 1e-9, numerics::IntegratorChoice::kAuto);
  double peak = 0.0;
  for (const bool at_peaks : {false, true}) {
    s.at_peaks = at_peaks;
    peak = 0.0;
    for (const Instant& i : simulate(m, s).instants) {
      peak = std::max(peak, i.joints[0].f_W.norm());
    }
    if (!at_peaks) {
      EXPECT_LT(peak, 1.0);
    }
  }
  const double stiff = std::sqrt(1e6 / (1.0 / 3.0));
  EXPECT_NEAR(peak, 0.5 * stiff, 1e-3);
}

}  // namespace
}  // namespace clevis::mechanism
