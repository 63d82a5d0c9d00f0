// What a mechanism holds and weighs at the joints of one of its bodies, against
// effective masses by hand.
#include "mechanism/neighbours/neighbour_inertia.h"

#include <complex>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <gtest/gtest.h>

#include "mechanism/simulate.h"
#include "support/free_linkages.h"

namespace clevis::mechanism {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using testing::pin;
using testing::uniform_bar;

constexpr double kRoundOff = 1e-9;

Instant placed(const MechanismDefinition& m) {
  Instant instant;
  for (const BodyDefinition& body : m.bodies) {
    instant.bodies.push_back({.pose = body.placement});
  }
  return instant;
}

/// Added mass of a motion of the places: none, if it is held.
double mass_of(const MatrixXd& weighed, const Eigen::VectorXd& motion) {
  return (weighed.transpose() * motion).squaredNorm();
}

/// The motion of a place alone, of Lo.
Eigen::VectorXd motion(const NeighbourInertia& found, int place,
                       const Vector3d& v) {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(found.held.rows());
  all.segment<3>(6 * place) = v;
  return all;
}

/// Two level bars of 1 m end to end, the first on the ground's pin at O.
MechanismDefinition two_bars(double second) {
  MechanismDefinition m;
  m.bodies = {uniform_bar("first", Vector3d::Zero(), 0.0, 1.0),
              uniform_bar("second", {1.0, 0.0, 0.0}, 0.0, 1.0)};
  m.bodies[1].mass_properties.mass *= second;
  m.bodies[1].mass_properties.inertia_LCm *= second;
  m.joints = {pin("O", kGround, 0, 0.0, 0.0), pin("A", 0, 1, 1.0, 0.0)};
  m.dimension = SpaceDimension::kPlanar;
  return m;
}

// A uniform bar that is pushed at its end weighs all along itself, a quarter
// across.
TEST(NeighbourInertia, OfAFreeBarAtItsEnd) {
  const MechanismDefinition m = two_bars(3.0);
  const double mass = m.bodies[1].mass_properties.mass;
  const NeighbourInertia found = neighbour_inertia(Neighbours(m, 0), placed(m));
  ASSERT_EQ(found.places.size(), 2U);
  EXPECT_EQ(found.places[0].joint, 0);
  EXPECT_EQ(found.places[1].joint, 1);
  EXPECT_EQ(found.held.cols(), 5);  // the ground's pin
  EXPECT_LT(found.held.bottomRows(6).norm(), kRoundOff);
  EXPECT_NEAR(mass_of(found.weighed, motion(found, 1, {1.0, 0.0, 0.0})), mass,
              kRoundOff * mass);
  EXPECT_NEAR(mass_of(found.weighed, motion(found, 1, {0.0, 1.0, 0.0})),
              0.25 * mass, 1e-3 * mass);
  EXPECT_LT(mass_of(found.weighed, motion(found, 0, {1.0, 1.0, 0.0})),
            kRoundOff);
}

// Of the second bar: the first turns about O, a third of its mass moves across
// with its end, none gives way along it.
TEST(NeighbourInertia, OfABarOnThePinOfTheGround) {
  const MechanismDefinition m = two_bars(1.0);
  const double mass = m.bodies[0].mass_properties.mass;
  const NeighbourInertia found = neighbour_inertia(Neighbours(m, 1), placed(m));
  ASSERT_EQ(found.places.size(), 1U);
  EXPECT_EQ(found.held.cols(), 4);
  EXPECT_EQ(found.weighed.cols(), 1);
  EXPECT_NEAR(mass_of(found.weighed, motion(found, 0, {0.0, 1.0, 0.0})),
              mass / 3.0, 1e-3 * mass);
  EXPECT_GT((found.held.transpose() * motion(found, 0, {1.0, 0.0, 0.0})).norm(),
            0.99);
}

// A drive holds what it turns, whoever asks.
TEST(NeighbourInertia, DrivesHold) {
  MechanismDefinition m = two_bars(1.0);
  DriveDefinition drive;
  drive.joint = 0;
  m.drives = {drive};
  const NeighbourInertia second =
      neighbour_inertia(Neighbours(m, 1), placed(m));
  EXPECT_EQ(second.held.cols(), 5);
  EXPECT_EQ(second.weighed.cols(), 0);
  const NeighbourInertia first = neighbour_inertia(Neighbours(m, 0), placed(m));
  ASSERT_EQ(first.places.size(), 3U);
  EXPECT_TRUE(first.places[2].is_drive);
  EXPECT_EQ(first.held.cols(), 6);
}

// A welded body adds all of its mass, and its inertia about the weld.
TEST(NeighbourInertia, OfAWeldedBody) {
  MechanismDefinition m = two_bars(2.0);
  m.dimension = SpaceDimension::kSpatial;
  m.joints[1].type = JointType::kWeld;
  const auto& given = m.bodies[1].mass_properties;
  const NeighbourInertia found = neighbour_inertia(Neighbours(m, 0), placed(m));
  EXPECT_EQ(found.held.cols(), 5);
  EXPECT_EQ(found.weighed.cols(), 6);
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(mass_of(found.weighed, motion(found, 1, Vector3d::Unit(k))),
                given.mass, kRoundOff * given.mass);
  }
  // A turn of Lo about z moves the centre, at 1.5 m, across.
  Eigen::VectorXd turn = Eigen::VectorXd::Zero(12);
  turn[11] = 1.0;
  EXPECT_NEAR(mass_of(found.weighed, turn),
              given.inertia_LCm(2, 2) + given.mass * 1.5 * 1.5,
              1e-3 * given.mass);
}

// Turning a momentum h at θ' takes the moment θ' × h, wherever it is held; of
// what turns with the body none.
TEST(NeighbourInertia, OfABodyThatSpins) {
  MechanismDefinition m = two_bars(1.0);
  m.dimension = SpaceDimension::kSpatial;
  m.joints[1].type = JointType::kWeld;
  Instant instant = placed(m);
  instant.bodies[0].w_WL = {10.0, 0.0, 0.0};
  instant.bodies[1].w_WL = {50.0, 0.0, 0.0};
  const Vector3d h(m.bodies[1].mass_properties.inertia_LCm(0, 0) * 40.0, 0, 0);
  const NeighbourInertia found = neighbour_inertia(Neighbours(m, 0), instant);
  ASSERT_EQ(found.spin.rows(), 12);
  for (int k = 0; k < 12; ++k) {
    Eigen::VectorXd expected = Eigen::VectorXd::Zero(12);
    if (k >= 9) expected.tail<3>() = Vector3d::Unit(k - 9).cross(h);
    EXPECT_LT((found.spin.col(k) - expected).norm(), kRoundOff * h.norm()) << k;
  }
  instant.bodies[1].w_WL = instant.bodies[0].w_WL;
  EXPECT_EQ(neighbour_inertia(Neighbours(m, 0), instant).spin.size(), 0);
}

/// A bar with springs on it or beside it, all relaxed.
NeighbourInertia sprung_bar(MechanismDefinition& m, int body,
                            std::vector<ForceElement> elements) {
  m.elements = std::move(elements);
  Instant instant = placed(m);
  instant.elements.resize(m.elements.size());
  return neighbour_inertia(Neighbours(m, body), instant);
}

LineElement spring(double stiffness, double damping) {
  LineElement element;
  element.law = SpringLaw{.stiffness = stiffness, .damping = damping};
  return element;
}

// A motor's rotor behind its gear turns with the bar on the ground's pin: of
// the second bar it weighs J n²/l² at the pin between both, of the first by
// itself.
TEST(NeighbourInertia, RotorsWeigh) {
  constexpr double kRatio = 10.0, kRotor = 1e-3;  // kg m²
  constexpr double kAtJoint = kRatio * kRatio * kRotor;
  MechanismDefinition m = two_bars(1.0);
  const Vector3d across(0.0, 1.0, 0.0);
  const double bar = mass_of(
      neighbour_inertia(Neighbours(m, 1), placed(m)).weighed,
      motion(neighbour_inertia(Neighbours(m, 1), placed(m)), 0, across));
  LineElement motor;
  motor.law = MotorLaw{.ratio = kRatio, .rotor_inertia = kRotor};
  motor.line = {.kind = ElementLine::Kind::kJoint, .joint = 0};
  const NeighbourInertia second = sprung_bar(m, 1, {motor});
  EXPECT_NEAR(mass_of(second.weighed, motion(second, 0, across)),
              bar + kAtJoint, 1e-6);
  const NeighbourInertia first = sprung_bar(m, 0, {motor});
  ASSERT_EQ(first.places.back().element, 0);
  Eigen::VectorXd turn = Eigen::VectorXd::Zero(first.held.rows());
  turn[first.held.rows() - 1] = 1.0;
  EXPECT_NEAR(mass_of(first.weighed, turn), kAtJoint, 1e-9);
}

// Between the first bar and the second, which turns freely: the rotor drags it
// along, J n² and m l²/3 one behind the other.
TEST(NeighbourInertia, RotorsDragWhatTurnsFreely) {
  constexpr double kAtJoint = 0.1;  // kg m²
  MechanismDefinition m = two_bars(1.0);
  LineElement motor;
  motor.law = MotorLaw{.ratio = 10.0, .rotor_inertia = 1e-2 * kAtJoint};
  motor.line = {.kind = ElementLine::Kind::kJoint, .joint = 1};
  const NeighbourInertia found = sprung_bar(m, 0, {motor});
  ASSERT_EQ(found.places.back().element, 0);
  Eigen::VectorXd turn = Eigen::VectorXd::Zero(found.held.rows());
  turn[found.held.rows() - 1] = 1.0;
  constexpr double kBar = 1.0 / 3.0;
  EXPECT_NEAR(mass_of(found.weighed, turn), kAtJoint * kBar / (kAtJoint + kBar),
              1e-6);
}

// A motor's current pushes back as a spring with a damper behind it: at rest
// nothing, when fast 3/2 (n p ψ)²/L.
TEST(NeighbourInertia, CurrentsOfMotorsRelax) {
  const MotorLaw law{.ratio = 20.0,
                     .pole_pairs = 4,
                     .resistance = 0.5,
                     .inductance = 5e-3,
                     .flux = 0.1};
  MechanismDefinition m = two_bars(1.0);
  LineElement motor;
  motor.law = law;
  motor.line = {.kind = ElementLine::Kind::kJoint, .joint = 0};
  const NeighbourInertia found = sprung_bar(m, 0, {motor});
  ASSERT_TRUE(found.swinging);
  EXPECT_EQ(found.sprung.cols(), 0);
  Eigen::VectorXd turn = Eigen::VectorXd::Zero(found.held.rows());
  turn[found.held.rows() - 1] = 1.0;
  const auto& [held, followed, sprung, damped, sprung_there, damped_there] =
      *found.swinging;
  const double volts = law.ratio * law.pole_pairs * law.flux;
  const double stiffness = 1.5 * volts * volts / law.inductance;
  const double decay = law.inductance / law.resistance;
  const Eigen::VectorXcd pushed = sprung_there * (sprung.transpose() * turn);
  for (const double of_decay : {0.1, 1.0, 10.0, 100.0}) {
    const std::complex<double> w(0.0, of_decay / decay);
    Eigen::MatrixXcd form =
        Eigen::MatrixXcd::Identity(sprung_there.rows(), sprung_there.rows());
    form *= w * w;
    form += sprung_there * sprung_there.transpose() +
            w * (damped_there * damped_there.transpose());
    const std::complex<double> found_stiffness =
        (sprung.transpose() * turn).squaredNorm() -
        (pushed.transpose() * form.fullPivLu().solve(pushed))(0);
    const std::complex<double> wanted =
        stiffness * w * decay / (1.0 + w * decay);
    EXPECT_LT(std::abs(found_stiffness - wanted), 0.04 * std::abs(wanted))
        << of_decay;
  }
}

// Of the second bar: the first turns about O against its spring as the pin
// between both moves across, k/l².
TEST(NeighbourInertia, SpringsHoldNeighbours) {
  MechanismDefinition m = two_bars(1.0);
  LineElement about = spring(700.0, 30.0);
  about.line.joint = 0;
  const NeighbourInertia found = sprung_bar(m, 1, {about});
  ASSERT_EQ(found.places.size(), 1U);
  const auto of = [&](const MatrixXd& wrenches, const Vector3d& v) {
    return mass_of(wrenches, motion(found, 0, v));
  };
  EXPECT_NEAR(of(found.sprung, {0.0, 1.0, 0.0}), 700.0, 1e-6 * 700.0);
  EXPECT_NEAR(of(found.damped, {0.0, 1.0, 0.0}), 30.0, 1e-6 * 30.0);
  EXPECT_LT(of(found.sprung, {1.0, 0.0, 0.0}), 1e-6);
  // Of the first: it stands on the spring itself, a place of its own.
  const NeighbourInertia first = sprung_bar(m, 0, {about});
  ASSERT_EQ(first.places.size(), 3U);
  EXPECT_EQ(first.places[2].element, 0);
  Eigen::VectorXd turn = Eigen::VectorXd::Zero(18);
  turn[17] = 2.0;
  EXPECT_NEAR(mass_of(first.sprung, turn), 4.0 * 700.0, 1e-9 * 700.0);
}

// From the ground up to the middle of the first bar. Springs that swing the
// second about its pin, from the ground or from the first, are left out.
TEST(NeighbourInertia, SpringsAlongLines) {
  MechanismDefinition m = two_bars(1.0);
  const auto up_to = [](int body) {
    LineElement up = spring(900.0, 0.0);
    up.line.kind = ElementLine::Kind::kDistance;
    up.line.a = {kGround, {0.5 + body, 1.0, 0.0}};
    up.line.b = {body, {0.5, 0.0, 0.0}};
    return up;
  };
  const NeighbourInertia first = sprung_bar(m, 0, {up_to(0)});
  ASSERT_EQ(first.places.size(), 3U);
  EXPECT_TRUE(first.left_out.empty());
  EXPECT_NEAR(mass_of(first.sprung, motion(first, 2, {0.0, 1.0, 0.0})), 900.0,
              1e-6);
  EXPECT_LT(mass_of(first.sprung, motion(first, 2, {1.0, 0.0, 0.0})), 1e-6);
  LineElement between = spring(700.0, 0.0);
  between.line.joint = 1;
  const NeighbourInertia second = sprung_bar(m, 0, {up_to(1), between});
  EXPECT_EQ(second.left_out, (std::vector{0, 1}));
  EXPECT_EQ(second.sprung.cols(), 0);
}

// Both bars on a spring between them, the first rigid: one swing, k 96/7 m l²,
// by angles θ of each, T = m l² (4 θ₁² + 3 θ₁ θ₂ + θ₂²)/6.
TEST(NeighbourInertia, NeighboursSwingOnSprings) {
  MechanismDefinition m = two_bars(1.0);
  LineElement between = spring(700.0, 0.0);
  between.line.joint = 1;
  const auto found = sprung_bar(m, 0, {between}).swinging;
  ASSERT_TRUE(found.has_value());
  const Eigen::Index motions = found->followed.rows(), all = 6 + motions;
  // Of Lo of the first bar, at each of its places, and of the second.
  MatrixXd at_places = MatrixXd::Zero(found->held.rows(), 6);
  for (Eigen::Index k = 0; k < at_places.rows(); ++k) {
    at_places(k, k % 6) = 1.0;
  }
  const auto rows = [&](const MatrixXd& wrenches, const MatrixXd& there) {
    MatrixXd both(wrenches.cols(), all);
    both << wrenches.transpose() * at_places, there.transpose();
    return both;
  };
  const auto& given = m.bodies[0].mass_properties;
  const double turn = given.inertia_LCm(2, 2) + given.mass * 0.25;
  MatrixXd mass = MatrixXd::Identity(all, all);
  mass.topLeftCorner(3, 3) *= given.mass;
  mass(1, 5) = mass(5, 1) = 0.5 * given.mass;
  mass(2, 4) = mass(4, 2) = -0.5 * given.mass;
  mass(4, 4) = mass(5, 5) = turn;
  const Eigen::JacobiSVD<MatrixXd> svd(rows(found->held, found->followed),
                                       Eigen::ComputeFullV);
  const auto held = (svd.singularValues().array() > 1e-9).count();
  const MatrixXd left = svd.matrixV().rightCols(all - held);
  const MatrixXd springs = rows(found->sprung, found->sprung_there) * left;
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> swings(
      springs.transpose() * springs, left.transpose() * mass * left,
      Eigen::EigenvaluesOnly);
  ASSERT_EQ(left.cols(), 2);
  EXPECT_NEAR(swings.eigenvalues()[0], 0.0, 1e-6 * 700.0);
  EXPECT_NEAR(swings.eigenvalues()[1], 700.0 * 96.0 / 7.0, 1.0);
}

// The second bar slides across on the first: along both it moves as that does.
TEST(NeighbourInertia, SpringsBetweenTheBodyAndANeighbour) {
  MechanismDefinition m = two_bars(1.0);
  m.dimension = SpaceDimension::kSpatial;
  m.joints[1].type = JointType::kPrismatic;  // along z of the pin
  LineElement between = spring(900.0, 0.0);
  between.line.kind = ElementLine::Kind::kDistance;
  between.line.a = {0, {0.5, 0.0, 0.0}};
  between.line.b = {1, {0.5, 0.0, 0.0}};
  const NeighbourInertia found = sprung_bar(m, 0, {between});
  // Along the bars: both ends move alike, or the body's alone.
  ASSERT_EQ(found.places.size(), 3U);
  Eigen::VectorXd both = Eigen::VectorXd::Zero(found.held.rows());
  both[6] = both[12] = 1.0;
  EXPECT_LT(mass_of(found.sprung, both), 1e-6);
  EXPECT_NEAR(mass_of(found.sprung, motion(found, 2, {1.0, 0.0, 0.0})), 900.0,
              1e-6);
}

// A body that a bushing alone joins to another is a neighbour: it swings.
TEST(NeighbourInertia, ABodyOnABushingSwings) {
  MechanismDefinition m = two_bars(1.0);
  m.dimension = SpaceDimension::kSpatial;
  m.joints.resize(1);
  BushingElement bushing;
  bushing.a = {0, {1.0, 0.0, 0.0}};
  bushing.b = {1, {0.0, 0.0, 0.0}};
  bushing.stiffness = 700.0 * BushingElement::Matrix6::Identity();
  const NeighbourInertia found = sprung_bar(m, 0, {bushing});
  ASSERT_TRUE(found.swinging);
  EXPECT_EQ(found.left_out.size(), 1U);
  EXPECT_EQ(found.sprung.cols(), 0);
  // Alone the part strains it; moved alike, at the other's kinetic energy of
  // m v²/2, they strain nothing.
  const Eigen::VectorXd strained =
      found.swinging->sprung.transpose() *
      motion(found, static_cast<int>(found.places.size()) - 1, {0.0, 1.0, 0.0});
  EXPECT_NEAR(strained.squaredNorm(), 700.0, 1e-6);
  const MatrixXd there = found.swinging->sprung_there.transpose();
  ASSERT_EQ(there.cols(), 6);
  const Eigen::VectorXd follows = -there.fullPivLu().solve(strained);
  EXPECT_LT((strained + there * follows).norm(), 1e-6);
  EXPECT_NEAR(follows.squaredNorm(), m.bodies[1].mass_properties.mass, 1e-4);
}

// Of a bushing and a point held to a place, on a free body: what its Lo and its
// turn about that cost, 2 E, from their definitions.
TEST(NeighbourInertia, BushingsAndImpedancesHold) {
  MechanismDefinition m;
  m.bodies = {uniform_bar("bar", Vector3d::Zero(), 0.0, 1.0)};
  BushingElement bushing;
  bushing.stiffness.diagonal() << 8e3, 9e3, 7e3, 3.0, 4.0, 5.0;
  bushing.a = {kGround, {0.8, 0.1, 0.0}};
  bushing.b = {0, {0.8, 0.1, 0.0}};
  ImpedanceElement impedance;
  impedance.point = {0, {0.3, -0.2, 0.5}};
  impedance.target_W = impedance.point.p_L;
  impedance.stiffness = 600.0;
  const auto cost = [&](const ForceElement& element, const Vector3d& v,
                        const Vector3d& w) {
    const NeighbourInertia found = sprung_bar(m, 0, {element});
    Eigen::VectorXd motion(6);
    motion << v, w;
    return mass_of(found.sprung, motion);
  };
  const Vector3d v(0.3, -0.7, 0.2), w(0.5, 0.4, -0.6);
  const Vector3d at_bushing = v + w.cross(bushing.b.p_L);
  const Eigen::Matrix<double, 6, 1> k = bushing.stiffness.diagonal();
  const double of_bushing =
      k.head<3>().dot(at_bushing.cwiseAbs2()) + k.tail<3>().dot(w.cwiseAbs2());
  EXPECT_NEAR(cost(bushing, v, w), of_bushing, 1e-9 * of_bushing);
  const double of_impedance =
      600.0 * (v + w.cross(impedance.point.p_L)).squaredNorm();
  EXPECT_NEAR(cost(impedance, v, w), of_impedance, 1e-9 * of_impedance);
}

// By their states: a wheel pressed into the ground, a stop run into, and an
// adiabatic chamber, κ p A²/V.
TEST(NeighbourInertia, ContactsStopsAndGasHoldByTheirStates) {
  MechanismDefinition m = two_bars(1.0);
  const auto cost = [&](const ForceElement& element, const ElementState& state,
                        int row) {
    m.elements = {element};
    Instant instant = placed(m);
    instant.elements = {state};
    const NeighbourInertia found = neighbour_inertia(Neighbours(m, 0), instant);
    if (found.places.size() < 3) return 0.0;
    Eigen::VectorXd motion = Eigen::VectorXd::Zero(18);
    motion[12 + row] = 2.0;
    return mass_of(found.sprung, motion) / 4.0;
  };
  ContactElement wheel;
  wheel.center = {0, {0.4, 0.0, 0.0}};
  wheel.radius = 0.1;
  wheel.law = {.stiffness = 5e4};
  EXPECT_NEAR(cost(wheel, {.position = 1e-3}, 1), 5e4, 1.0);
  EXPECT_NEAR(cost(wheel, {.position = 1e-3}, 5), 5e4 * 0.16, 1.0);
  EXPECT_LT(cost(wheel, {.position = 1e-3}, 0), 1e-6);
  EXPECT_EQ(cost(wheel, {.position = -1e-3}, 1), 0.0);
  LineElement stop;
  stop.line.joint = 0;
  stop.law = StopLaw{
      .lower = std::nullopt, .upper = 0.2, .contact = {.stiffness = 300.0}};
  EXPECT_NEAR(cost(stop, {.position = 0.25}, 5), 300.0, 0.01);
  EXPECT_EQ(cost(stop, {.position = 0.1}, 5), 0.0);
  LineElement gas;
  gas.line.kind = ElementLine::Kind::kDistance;
  gas.line.a = {kGround, {0.5, 1.0, 0.0}};
  gas.line.b = {0, {0.5, 0.0, 0.0}};
  GasCylinderLaw cylinder;
  cylinder.sections = 2;
  cylinder.chambers.resize(1);
  cylinder.chambers[0].area = 1e-3;
  gas.law = cylinder;
  ElementState filled;
  filled.chambers = {{.volume = 1e-4, .pressure = 5e5}};
  const double stiff =
      2.0 * cylinder.gas.isentropic_exponent() * 5e5 * 1e-6 / 1e-4;
  EXPECT_NEAR(cost(gas, filled, 1), stiff, 1e-9 * stiff);
}

// A block along a rack that a drive holds: its pinion rolls, and so weighs
// m + I/r² along it. By angles against the block it would slide.
TEST(NeighbourInertia, PinionRollsOnItsRack) {
  constexpr double kRadius = 0.05;
  MechanismDefinition m;
  m.bodies = {uniform_bar("block", Vector3d::Zero(), 0.0, 1.0),
              uniform_bar("pinion", Vector3d::Zero(), 0.0, 1.0),
              uniform_bar("rack", Vector3d::Zero(), 0.0, 1.0)};
  m.bodies[1].mass_properties.p_LCm.setZero();
  m.joints = {pin("bearing", 0, 1, 0.0, 0.0), pin("rail", kGround, 2, 0.0, 0.0),
              pin("foot", kGround, 0, 0.0, 0.0)};
  m.joints[1].type = JointType::kPrismatic;
  const Eigen::Matrix3d along(
      Eigen::AngleAxisd(0.5 * std::numbers::pi, Vector3d::UnitY()));
  m.joints[1].frame_a.R_LJ = m.joints[1].frame_b.R_LJ = along;
  m.joints[2].type = JointType::kWeld;
  CouplingDefinition& mesh = m.couplings.emplace_back();
  mesh.joint_1 = 1;
  mesh.joint_2 = 0;
  mesh.ratio = kRadius;
  mesh.teeth.emplace();
  m.drives.resize(1);
  m.drives[0].joint = 1;
  Instant instant = placed(m);
  instant.couplings.resize(1);
  const NeighbourInertia found = neighbour_inertia(Neighbours(m, 0), instant);
  const int bearing = found.places[0].joint == 0 ? 0 : 1;
  const auto& pinion = m.bodies[1].mass_properties;
  EXPECT_NEAR(mass_of(found.weighed, motion(found, bearing, {1.0, 0.0, 0.0})),
              pinion.mass + pinion.inertia_LCm(2, 2) / (kRadius * kRadius),
              1e-6);
}

}  // namespace
}  // namespace clevis::mechanism
