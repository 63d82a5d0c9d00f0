// Answers to a strike against closed forms and published values. Source:
// docs/theory.md, "Vibration and impact".

#include "dynamics/strike/strike.h"

#include <cmath>
#include <complex>
#include <cstdio>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "dynamics/struck_body/contact_law.h"
#include "dynamics/struck_body/damped_body.h"
#include "dynamics/struck_body/damped_scheme.h"
#include "dynamics/struck_body/excited_shapes.h"
#include "support/damped_blow.h"
#include "support/dense_system.h"
#include "support/rod_peak.h"

namespace clevis {
namespace {

using dynamics::Route;
using dynamics::StrikeOptions;
using dynamics::StrikeSolution;
using Eigen::MatrixXd;
using Eigen::VectorXd;

loads::Strike strike_of(double mass, double speed,
                        const loads::ContactSpring& contact, double duration) {
  loads::Strike strike;
  strike.name = "test";
  strike.mass = mass;
  strike.speed = speed;
  strike.contact = contact;
  strike.duration = duration;
  return strike;
}

StrikeOptions options_of(Route route, int samples = 400) {
  StrikeOptions options;
  options.route = route;
  options.samples = samples;
  return options;
}

/// One coordinate of the displacements at the samples.
VectorXd row_of(const StrikeSolution& solution, Eigen::Index row) {
  return solution.is_modal ? VectorXd(solution.run.states.transpose() *
                                      solution.columns.row(row).transpose())
                           : VectorXd(solution.run.states.row(row).transpose());
}

TEST(ContactLaw, MeanForceDoesTheWorkOfThePotential) {
  for (const double exponent : {1.0, 1.5}) {
    const dynamics::ContactLaw law({2e7, exponent, false});
    for (const auto& [a, b] : std::vector<std::pair<double, double>>{
             {1e-5, 3e-5}, {2e-5, 2.0001e-5}, {-1e-5, 2e-5}, {3e-5, -1e-5}}) {
      EXPECT_NEAR(law.mean_force(a, b) * (b - a),
                  law.potential(b) - law.potential(a),
                  1e-13 * law.potential(3e-5));
      const double mean = law.solve_step(a, b, 1e-7);
      EXPECT_NEAR(mean, law.mean_force(a, b - 1e-7 * mean),
                  1e-9 * law.force(3e-5));
    }
    EXPECT_EQ(law.solve_step(-1e-5, -2e-6, 1e-7), 0.0);
  }
}

/// Massless spring and mass under a constant force: the formula of the energy
/// method is exact, y_max = y_st + √(y_st² + m V² y_st/F).
TEST(Strike, MasslessBodyGivesTheEnergyFormula) {
  const double k = 1e6, mass = 0.2, speed = 1.3, force = 80.0;
  auto system = support::dense_system(MatrixXd::Constant(1, 1, k),
                                      MatrixXd::Constant(1, 1, 1e-6 * mass));
  auto strike = strike_of(mass, speed, {2000.0 * k, 1.0, true}, 2.5e-3);
  strike.force = force;
  const double y_static = force / k;
  const double exact =
      y_static +
      std::sqrt(y_static * y_static + mass * speed * speed * y_static / force);
  const auto solution = dynamics::solve_strike(
      system, VectorXd::Ones(1), strike, options_of(Route::kModal), "test");
  EXPECT_NEAR(solution.run.peak_contact / exact, 1.0, 2e-3);
  EXPECT_LT(solution.run.energy_error, 1e-9);
}

/// A sphere of 1 cm/s on a rigid support: 7.10 N, 172.7 µs (Hertz).
TEST(Strike, HertzOnARigidSupport) {
  auto system = support::dense_system(MatrixXd::Constant(1, 1, 1e16),
                                      MatrixXd::Constant(1, 1, 1.0));
  const auto solution = dynamics::solve_strike(
      system, VectorXd::Ones(1),
      strike_of(0.033343, 0.01, {1.58056e10, 1.5, false}, 250e-6),
      options_of(Route::kModal), "test");
  EXPECT_NEAR(solution.run.peak_force, 7.10, 0.005);
  EXPECT_NEAR(solution.run.release_time * 1e6, 172.7, 0.5);
  EXPECT_EQ(solution.run.touches, 1);
  EXPECT_NEAR(solution.run.speed.tail(1).value(), -0.01, 1e-5);
}

/// Timoshenko (1913): steel sphere on a simply supported beam, Euler-Bernoulli
/// with Hertz. P_max 4.977 N at 72.6 µs, contact 156.4 µs, w_max 1.12476 µm at
/// 323.7 µs, rebound −3.023 mm/s, impulse 4.3423e-4 N s.
TEST(Strike, TimoshenkosSphereOnABeam) {
  const double side = 0.01;
  const support::EulerBeam beam{0.1535, 215.746e9 * std::pow(side, 4) / 12.0,
                                7960.0 * side * side, 20};
  // Deflections of both ends held: the last node's first.
  const auto held = [](const MatrixXd& matrix) {
    return support::without(support::without(matrix, 40), 0);
  };
  const auto system =
      support::dense_system(held(beam.stiffness()), held(beam.mass()));
  for (const Route route : {Route::kModal, Route::kDirect}) {
    const auto solution = dynamics::solve_strike(
        system, VectorXd::Unit(40, 19),
        strike_of(0.033343, 0.01, {1.58056e10, 1.5, false}, 400e-6),
        options_of(route), "test");
    const auto& run = solution.run;
    EXPECT_TRUE(solution.within_tolerance);
    EXPECT_NEAR(run.peak_force, 4.977, 1e-3);
    EXPECT_NEAR(run.peak_force_time * 1e6, 72.6, 0.5);
    EXPECT_NEAR(run.release_time * 1e6, 156.4, 0.5);
    EXPECT_NEAR(run.peak_contact * 1e6, 1.12476, 2e-4);
    EXPECT_NEAR(run.peak_contact_time * 1e6, 323.7, 0.6);
    EXPECT_NEAR(run.speed.tail(1).value() * 1e3, -3.023, 1e-3);
    EXPECT_NEAR(run.impulse.tail(1).value(), 4.3423e-4, 1e-7);
    EXPECT_LT(run.energy_error, 1e-9);
  }
}

/// Steel rod 10 × 60 mm struck at its free end with 1 m/s.
struct StruckCantilever {
  static constexpr double kLength = 0.06, kMass = 0.0370;
  int elements = 20;
  support::EulerBeam beam{kLength, 210e9 * std::numbers::pi * 1e-8 / 64.0,
                          kMass / kLength, elements};

  /// Root moment over that of the energy formula, V √(3 E I m/h).
  double root_moment(const loads::ContactSpring& contact, double ratio,
                     Route route) const {
    const double striker = ratio * kMass;
    const auto system =
        support::dense_system(support::without_first(beam.stiffness(), 2),
                              support::without_first(beam.mass(), 2));
    const double period = 2.0 * std::numbers::pi *
                          std::sqrt(striker * std::pow(kLength, 3) /
                                    (3.0 * beam.bending_stiffness));
    auto options = options_of(route, 4000);
    options.damping = dynamics::Damping::kNone;
    const auto solution = dynamics::solve_strike(
        system, VectorXd::Unit(2 * elements, 2 * elements - 2),
        strike_of(striker, 1.0, contact, 0.75 * period), options, "test");
    EXPECT_LT(solution.run.energy_error, 1e-8);
    const double h = kLength / elements;
    return beam.bending_stiffness / (h * h) *
           (6.0 * row_of(solution, 0) - 2.0 * h * row_of(solution, 1))
               .cwiseAbs()
               .maxCoeff();
  }
  double formula(double ratio) const {
    return std::sqrt(3.0 * beam.bending_stiffness * ratio * kMass / kLength);
  }
};

/// The reference figures are given to three digits.
TEST(Strike, BilateralContactSpringsOnACantilever) {
  const StruckCantilever rod;
  const double ratio = 0.2 / StruckCantilever::kMass;
  for (const Route route : {Route::kModal, Route::kDirect}) {
    EXPECT_NEAR(rod.root_moment({1e6, 1.0, true}, ratio, route), 23.07, 0.05);
    EXPECT_NEAR(rod.root_moment({1e7, 1.0, true}, ratio, route), 34.66, 0.05);
    EXPECT_NEAR(rod.root_moment({1e8, 1.0, true}, ratio, route), 40.7, 0.1);
  }
}

TEST(Strike, UnilateralContactSpringsOnACantilever) {
  const StruckCantilever rod;
  const auto over_formula = [&](double stiffness, double ratio) {
    return rod.root_moment({stiffness, 1.0, false}, ratio, Route::kAuto) /
           rod.formula(ratio);
  };
  EXPECT_NEAR(over_formula(1e7, 5.4), 1.064, 1.5e-3);
  EXPECT_NEAR(over_formula(1e7, 20), 1.016, 1.5e-3);
  EXPECT_NEAR(over_formula(1e7, 100), 0.969, 1.5e-3);
  EXPECT_NEAR(over_formula(1e6, 5.4), 0.72, 5e-3);
  EXPECT_NEAR(over_formula(1e6, 20), 0.69, 5e-3);
  EXPECT_NEAR(over_formula(1e6, 100), 0.66, 5e-3);
}

/// 50 g at 1 m/s: several touches, and modes that lose at unlike paces. Both
/// without and with the damping of fronts, which leaves these waves alone.
TEST(Strike, DampedModesAgainstRungeAndKutta) {
  const StruckCantilever rod;
  const MatrixXd k = support::without_first(rod.beam.stiffness(), 2);
  const MatrixXd m = support::without_first(rod.beam.mass(), 2);
  const VectorXd tip = VectorXd::Unit(2 * rod.elements, 2 * rod.elements - 2);
  const double h = StruckCantilever::kLength / rod.elements;
  MatrixXd moment = MatrixXd::Zero(1, 2 * rod.elements);
  moment(0, 0) = 6.0 * rod.beam.bending_stiffness / (h * h);
  moment(0, 1) = -2.0 * rod.beam.bending_stiffness / h;
  const auto system = support::dense_system(k, m);
  constexpr double kDuration = 1e-3;
  for (const double damping : {0.01, 0.05, 0.2}) {
    const auto exact = support::damped_blow(
        k, m, tip, moment, {0.05, 1.0, 1e7, damping}, kDuration, 16);
    for (const double front : {0.0, 2e-7}) {
      auto options = options_of(Route::kModal, 4000);
      options.modal_damping = damping;
      options.wave_front_time = front;
      options.damping =
          front > 0.0 ? dynamics::Damping::kFronts : dynamics::Damping::kNone;
      const auto found = dynamics::solve_strike(
          system, tip, strike_of(0.05, 1.0, {1e7, 1.0, false}, kDuration),
          options, "test");
      const VectorXd root =
          moment(0, 0) * row_of(found, 0) + moment(0, 1) * row_of(found, 1);
      EXPECT_NEAR(found.run.peak_force / exact.force, 1.0, 2e-3) << damping;
      EXPECT_NEAR(found.run.peak_contact / exact.way, 1.0, 1e-3) << damping;
      EXPECT_NEAR(root.cwiseAbs().maxCoeff() / exact.largest[0], 1.0, 2e-3)
          << damping;
    }
  }
}

/// The tip takes the striker's speed at once: the root moment rises with every
/// finer mesh (39.5, 43.1, 46.2, 49.3, 52.8 N m), the deflection settles.
TEST(Strike, IdealVelocityStepDoesNotConverge) {
  std::vector<double> moments, deflections;
  for (const int elements : {5, 10, 20, 40, 80}) {
    const StruckCantilever rod{elements};
    const MatrixXd k = support::without_first(rod.beam.stiffness(), 2);
    MatrixXd m = support::without_first(rod.beam.mass(), 2);
    const int tip = 2 * elements - 2;
    m(tip, tip) += 0.2;
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> modes(k, m);
    const VectorXd omega = modes.eigenvalues().cwiseSqrt();
    const VectorXd speed = modes.eigenvectors().transpose() * m.col(tip);
    const double h = StruckCantilever::kLength / elements;
    double moment = 0.0, deflection = 0.0;
    constexpr int kInstants = 8000;
    for (int i = 0; i < kInstants; ++i) {
      const double time = 1.4e-3 * i / kInstants;
      const VectorXd q =
          ((omega * time).array().sin() / omega.array()) * speed.array();
      const VectorXd u = modes.eigenvectors() * q;
      moment = std::max(moment, std::abs(6.0 * u[0] - 2.0 * h * u[1]) *
                                    rod.beam.bending_stiffness / (h * h));
      deflection = std::max(deflection, u[tip]);
    }
    moments.push_back(moment);
    deflections.push_back(deflection);
  }
  const double reference[] = {39.5, 43.1, 46.2, 49.3, 52.8};
  // Fine meshes: ever narrower spikes, between which instants fall.
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(moments[i] / reference[i], 1.0, i < 3 ? 0.002 : 0.025);
  }
  EXPECT_TRUE(dynamics::grows_with_refinement(moments));
  EXPECT_FALSE(dynamics::grows_with_refinement(deflections));
  EXPECT_FALSE(dynamics::grows_with_refinement({40.776, 40.744, 40.676}));
}

TEST(Strike, InfiniteStiffnessIsAnIdealStep) {
  const StruckCantilever rod;
  const auto system =
      support::dense_system(support::without_first(rod.beam.stiffness(), 2),
                            support::without_first(rod.beam.mass(), 2));
  const auto solution = dynamics::solve_strike(
      system, VectorXd::Unit(40, 38),
      strike_of(0.2, 1.0, {std::numeric_limits<double>::infinity(), 1.0, true},
                1.4e-3),
      options_of(Route::kAuto), "test");
  EXPECT_TRUE(solution.is_ideal);
  // 0.982 of the energy formula: 1 m/s √(m h³/3 E I).
  EXPECT_NEAR(
      solution.run.peak_contact / (0.2 / rod.formula(0.2 / 0.0370) * 0.06),
      0.982, 5e-3);
}

/// Rigid mass on a rod held at its far end, σ_max/σ₀ there: 2.27067, 2.73576,
/// 3.21306 at mass ratios 1, 2, 4 (d'Alembert). The peak stands right behind a
/// front: a contact that rises within 1/1250 of the wave's way through the rod
/// lowers it by 1.5 % at ratio 1. The rod's exact modes, √2 sin ω x with
/// ω = (n − ½) π.
TEST(Strike, RigidMassOnARod) {
  constexpr int kModes = 2500, kStride = 13;
  const double rise = 8e-4;
  VectorXd omega(kModes), tip(kModes);
  for (int n = 0; n < kModes; ++n) {
    omega[n] = (n + 0.5) * std::numbers::pi;
    tip[n] = std::sqrt(2.0) * (n % 2 == 0 ? 1.0 : -1.0);
  }
  const auto body = dynamics::modal_body(omega.cwiseAbs2(), tip);
  for (const auto& [ratio, exact] : std::vector<std::pair<double, double>>{
           {1.0, 2.27067}, {2.0, 2.73576}, {4.0, 3.21306}}) {
    EXPECT_NEAR(support::rod_peak(ratio, 1e-4) / exact, 1.0, 3e-3);
    const auto run = dynamics::run_strike(
        *body, strike_of(ratio, 1.0, {1.0 / rise, 1.0, false}, 3.1), 3.1, 3100,
        kStride);
    const double stress =
        (std::sqrt(2.0) * omega.transpose() * run.states).maxCoeff();
    std::printf("mass ratio %g: %.5f (%+.2f %%), step %.1e of the transit\n",
                ratio, stress, 100.0 * (stress / exact - 1.0), run.step);
    EXPECT_NEAR(stress / exact, 1.0, 0.02);
    EXPECT_NEAR(stress / support::rod_peak(ratio, rise), 1.0, 5e-3);
    EXPECT_LT(run.energy_error, 1e-9);
  }
}

/// The same rod in elements of degree 4: shapes that the contact excites and
/// have twice the contact's own frequency carry the front.
TEST(Strike, RigidMassOnARodOfElements) {
  const double rise = 4e-3;
  const support::UnitRod rod(200);
  auto options = options_of(Route::kModal, 3100);
  options.tolerance = 1e-2;
  options.fewest_modes = options.most_modes = 300;
  const auto solution = dynamics::solve_strike(
      rod.system, VectorXd::Unit(800, 799),
      strike_of(4.0, 1.0, {1.0 / rise, 1.0, false}, 3.1), options, "test");
  const double stress =
      (rod.root_stress() * solution.columns.topRows(4) * solution.run.states)
          .maxCoeff();
  EXPECT_NEAR(stress / support::rod_peak(4.0, rise), 1.0, 5e-3);
  EXPECT_NEAR(stress / 3.21306, 1.0, 0.02);
}

/// Both routes, a free body and a held one.
TEST(Strike, RoutesAgreeOnAFreeBeam) {
  const support::EulerBeam beam{0.1, 100.0, 0.5, 12};
  auto system = support::dense_system(beam.stiffness(), beam.mass());
  system.rigid = MatrixXd::Zero(26, 2);
  for (int node = 0; node <= 12; ++node) {
    system.rigid(2 * node, 0) = 1.0;
    system.rigid(2 * node, 1) = 0.1 * node / 12.0;
    system.rigid(2 * node + 1, 1) = 1.0;
  }
  system.low_square = 1e5;
  const auto strike = strike_of(0.02, 0.5, {1e6, 1.0, false}, 3e-3);
  const VectorXd contact = VectorXd::Unit(26, 24);
  const auto modal = dynamics::solve_strike(system, contact, strike,
                                            options_of(Route::kAuto), "test");
  const auto direct = dynamics::solve_strike(
      system, contact, strike, options_of(Route::kDirect), "test");
  EXPECT_TRUE(modal.is_modal);
  EXPECT_FALSE(direct.is_modal);
  EXPECT_LT(dynamics::difference(modal.run, direct.run), 3e-3);
  EXPECT_LT(direct.run.energy_error, 1e-6);
  // Momentum: what the striker lost the beam has.
  EXPECT_NEAR(modal.run.impulse.tail(1).value(),
              0.02 * (0.5 - modal.run.speed.tail(1).value()), 1e-12);
}

/// R of the damping scheme: fourth order, no growth, nothing left at infinity.
// One mode under a constant force, by steps of any length: the closed form.
TEST(ModalBody, DampedModeUnderAConstantForce) {
  const double omega = 300.0, zeta = 0.2, contact = 0.7, force = 5.0;
  const double root = std::sqrt(1.0 - zeta * zeta), end = 0.02;
  const double fall = std::exp(-zeta * omega * end);
  const double phase = root * omega * end;
  const double shown =
      contact * contact * force / (omega * omega) *
      (1.0 - fall * (std::cos(phase) + zeta / root * std::sin(phase)));
  // without a scheme that damps fronts, and with its fourth order
  for (const auto& [front, error] : {std::pair{0.0, 1e-10}, {1e-4, 1e-5}}) {
    const auto body =
        dynamics::modal_body(VectorXd::Constant(1, omega * omega),
                             VectorXd::Constant(1, contact), front, zeta);
    for (const int steps : {1, 7, 100000}) {
      body->rest();
      body->set_step(end / steps);
      for (int i = 0; i < steps; ++i) {
        body->free_contact();
        body->advance(force);
      }
      EXPECT_NEAR(body->contact(), shown, error * shown) << steps << front;
    }
  }
}

TEST(DampedScheme, IsOfFourthOrderAndLStable) {
  using dynamics::DampedScheme;
  double error = 0.0;
  for (const double phase : {0.2, 0.1}) {
    const auto exact = std::polar(1.0, phase);
    const double now = std::abs(DampedScheme::amplification(phase) - exact);
    if (error > 0.0) {
      EXPECT_NEAR(std::log2(error / now), 5.0, 0.1);
    }
    error = now;
  }
  for (double phase = 1e-3; phase < 1e6; phase *= 1.1) {
    EXPECT_LE(std::abs(DampedScheme::amplification(phase)), 1.0 + 1e-12);
    const auto half = DampedScheme::amplification(phase, 0.5);
    EXPECT_LT(std::abs(half * half - DampedScheme::amplification(phase)),
              1e-12);
  }
  EXPECT_LT(std::abs(DampedScheme::amplification(1e6)), 1e-5);
}

/// Shapes and equations damp alike; energy only falls; of a free body momentum
/// stays.
TEST(Strike, DampedRoutesAgree) {
  const support::EulerBeam beam{0.1, 100.0, 0.5, 6};
  auto system = support::dense_system(beam.stiffness(), beam.mass());
  system.rigid = MatrixXd::Zero(14, 2);
  for (int node = 0; node <= 6; ++node) {
    system.rigid(2 * node, 0) = 1.0;
    system.rigid(2 * node, 1) = 0.1 * node / 6.0;
    system.rigid(2 * node + 1, 1) = 1.0;
  }
  system.low_square = 1e5;
  const VectorXd contact = VectorXd::Unit(14, 12);
  const auto strike = strike_of(0.02, 0.5, {1e6, 1.0, false}, 1e-3);
  const double step = 1e-3 / 400;
  const auto direct = dynamics::damped_body(system, contact);
  const auto by_steps = dynamics::run_strike(*direct, strike, 1e-3, 400, 1);
  dynamics::ExcitedShapes shapes(system, contact);
  const auto model = shapes.model(12);
  const auto modal = dynamics::modal_body(model.squares, model.contact, step);
  const auto by_shapes = dynamics::run_strike(*modal, strike, 1e-3, 400, 1);
  EXPECT_LT(dynamics::difference(by_steps, by_shapes), 1e-8);
  EXPECT_NEAR(by_steps.energy_error, by_shapes.energy_error, 1e-8);
  EXPECT_GT(by_steps.energy_error, 1e-6);
  EXPECT_NEAR(by_steps.impulse.tail(1).value(),
              0.02 * (0.5 - by_steps.speed.tail(1).value()), 1e-12);
}

TEST(Strike, RefusesWhatIsNoStrike) {
  const auto system =
      support::dense_system(MatrixXd::Identity(1, 1), MatrixXd::Identity(1, 1));
  const auto code = [&](const loads::Strike& strike) {
    try {
      dynamics::solve_strike(system, VectorXd::Ones(1), strike, {}, "part x");
    } catch (const Error& error) {
      return error.code();
    }
    return std::string("none");
  };
  EXPECT_EQ(code(strike_of(0.0, 1.0, {1.0, 1.0, false}, 1.0)), "F006");
  EXPECT_EQ(code(strike_of(1.0, 0.0, {1.0, 1.0, false}, 1.0)), "F006");
  EXPECT_EQ(code(strike_of(1.0, 1.0, {0.0, 1.0, false}, 1.0)), "F006");
  EXPECT_EQ(code(strike_of(1.0, 1.0, {1.0, 1.5, true}, 1.0)), "F006");
  EXPECT_EQ(code(strike_of(1.0, 1.0, {1.0, 1.0, false}, 0.0)), "F006");
}

}  // namespace
}  // namespace clevis
