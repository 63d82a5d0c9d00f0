#include "beam/estimates/beam_estimate.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "beam/sections/pin_line.h"
#include "beam/theory/formulas.h"
#include "loads/history/balance.h"
#include "unit/beam/bar.h"

namespace clevis::beam {
namespace {

using Eigen::Vector3d;
using Forces = std::vector<Vector3d>;

BeamEstimate estimate_bar(const Bar& bar,
                          const std::vector<loads::GroupGeometry>& groups,
                          const loads::LoadHistory& history) {
  return estimate(bar.model(), steel(), bar.mass(), groups, history);
}

BeamStress worst_of(const BeamEstimate& estimate, const std::string& formula) {
  const auto found =
      std::ranges::find(estimate.stresses, formula, &BeamStress::formula);
  return found == estimate.stresses.end() ? BeamStress{} : *found;
}

double stress_of(const BeamEstimate& estimate, const std::string& formula) {
  return worst_of(estimate, formula).stress;
}

// AB of the landing gear: 1118 N on 20 × 5 mm are 11.18 MPa.
TEST(BeamEstimate, TwoForceMemberCarriesForceOverArea) {
  const Bar bar{.start = -0.02, .end = 0.16};
  const std::vector groups{pin_group("A", 0.0), pin_group("B", 0.14)};
  const BeamEstimate e = estimate_bar(
      bar, groups,
      pin_history(groups, {{-1118.0, 0.0, 0.0}, {1118.0, 0.0, 0.0}}));
  EXPECT_NEAR(stress_of(e, "axial + bending"), 11.18e6, 1.0);
  EXPECT_NEAR(e.deflection, 1118.0 * 0.14 / (210e9 * 100e-6), 1e-15);
  EXPECT_FALSE(e.buckling);
}

TEST(BeamEstimate, CompressedMemberBucklesAboutItsWeakAxis) {
  const Bar bar{.start = -0.02, .end = 0.16};
  const std::vector groups{pin_group("A", 0.0), pin_group("B", 0.14)};
  const auto history =
      pin_history(groups, {{1118.0, 0.0, 0.0}, {-1118.0, 0.0, 0.0}});
  const double I = 20e-3 * std::pow(5e-3, 3) / 12.0;
  const double pi = std::numbers::pi;
  const BeamEstimate own = estimate_bar(bar, groups, history);
  EXPECT_NEAR(own.buckling->load, pi * pi * 210e9 * I / (0.14 * 0.14),
              1e-9 * own.buckling->load);
  EXPECT_NEAR(own.buckling->safety, own.buckling->load / 1118.0, 1e-9);
  const BeamEstimate longer =
      estimate(bar.model(), steel(), bar.mass(), groups, history, 0.28);
  EXPECT_NEAR(longer.buckling->load, own.buckling->load / 4.0,
              1e-9 * own.buckling->load);
}

// BC of the landing gear: 500 N across at T, 80 mm beyond B, make 40 N m at
// B.
TEST(BeamEstimate, OverhangBendsLikeACantilever) {
  const Bar bar{.start = -0.02, .end = 0.15, .height = 18e-3};
  const std::vector groups{pin_group("C", 0.0), pin_group("B", 0.06),
                           pin_group("T", 0.14)};
  const double P = 500.0;
  const double B = -P * 0.14 / 0.06;
  const auto history =
      pin_history(groups, {{0.0, -P - B, 0.0}, {0.0, B, 0.0}, {0.0, P, 0.0}});
  const BeamEstimate e = estimate_bar(bar, groups, history);
  const BeamStress worst = worst_of(e, "axial + bending");
  EXPECT_NEAR(worst.stress, 40.0 / bar.section_modulus(), 15.0);
  EXPECT_TRUE(worst.where == "C-B at 60 mm" || worst.where == "B-T at 0 mm")
      << worst.where;
  EXPECT_EQ(worst.instant, 0.5);
  // Shear force is largest between C and B: 1.5 V/A, no axial force.
  EXPECT_NEAR(stress_of(e, "axial + shear"),
              std::sqrt(3.0) * 1.5 * std::abs(P + B) / bar.area(), 1.0);
}

TEST(BeamEstimate, OverhangDeflectionIsMeasuredFromTheFirstTwoPins) {
  const Bar bar{.start = -0.02, .end = 0.15, .height = 18e-3};
  const std::vector groups{pin_group("C", 0.0), pin_group("B", 0.06),
                           pin_group("T", 0.14)};
  const double P = 500.0, a = 0.08, l = 0.06;
  const auto history = pin_history(
      groups,
      {{0.0, P * a / l, 0.0}, {0.0, -P * (1.0 + a / l), 0.0}, {0.0, P, 0.0}});
  // Simply supported beam with overhang: tip P a² (l + a)/(3 E I).
  const double wanted =
      P * a * a * (l + a) / (3.0 * 210e9 * bar.second_moment());
  // Strains are linear between stations, extended over the pins.
  EXPECT_NEAR(estimate_bar(bar, groups, history).deflection, wanted,
              1e-3 * wanted);
}

// An arm on three pins of 12 mm: the largest moment stands at the middle one,
// 9.7 % above that at the rim of its bore.
TEST(BeamEstimate, ArmBendsMostAtItsMiddlePin) {
  const double radius = 6e-3, a = 0.06, b = 0.09, F = 418.0;
  const Bar bar{.start = -0.015, .end = a + b + 0.015, .height = 24e-3};
  const std::vector groups{pin_group("A", 0.0, radius),
                           pin_group("B", a, radius),
                           pin_group("C", a + b, radius)};
  for (const double axial : {0.0, 700.0}) {
    const BeamEstimate e =
        estimate_bar(bar, groups,
                     pin_history(groups, {{-axial, F * b / a, 0.0},
                                          {0.0, -F * (1.0 + b / a), 0.0},
                                          {axial, F, 0.0}}));
    const double wanted = F * b / bar.section_modulus() + axial / bar.area();
    EXPECT_NEAR(stress_of(e, "axial + bending"), wanted, 1e-6 * wanted);
  }
}

TEST(BeamEstimate, ThreePointBending) {
  const double L = 0.2, P = 300.0;
  const Bar bar{.start = -0.01, .end = 0.21};
  const std::vector groups{pin_group("A", 0.0), pin_group("B", L),
                           pin_group("M", L / 2.0)};
  const Forces forces{
      {0.0, -P / 2.0, 0.0}, {0.0, -P / 2.0, 0.0}, {0.0, P, 0.0}};
  const BeamEstimate e = estimate_bar(bar, groups, pin_history(groups, forces));
  const double peak = P * L / 4.0 / bar.section_modulus();
  EXPECT_NEAR(stress_of(e, "axial + bending"), peak, 1e-6 * peak);
  const double sag = P * L * L * L / (48.0 * 210e9 * bar.second_moment());
  EXPECT_NEAR(e.deflection, sag, 1e-3 * sag);
  // With the middle pin as second reference the far end moves twice as far.
  const std::vector reordered{groups[0], groups[2], groups[1]};
  const BeamEstimate other =
      estimate_bar(bar, reordered,
                   pin_history(reordered, {forces[0], forces[2], forces[1]}));
  EXPECT_NEAR(other.deflection, 2.0 * sag, 2e-3 * sag);
}

// Bar pulled by σ_0 on one end and held by its inertia: σ(x) = σ_0 x/L.
TEST(BeamEstimate, AcceleratedBar) {
  const Bar bar{.start = 0.0, .end = 0.2};
  const std::vector groups{pin_group("A", 0.0), pin_group("B", 0.2)};
  const double sigma = 50e6;
  auto history =
      pin_history(groups, {{0.0, 0.0, 0.0}, {sigma * bar.area(), 0.0, 0.0}});
  history.instants[0].rigid.acceleration.x() = sigma / (7850.0 * 0.2);
  const auto lines = pin_lines(bar.model(), bar.mass(), groups, history);
  ASSERT_EQ(lines.size(), 1u);
  const Span& span = lines[0].spans.at(0);
  ASSERT_EQ(span.stations.size(), 25u);
  for (std::size_t k = 0; k < 25; ++k) {
    const auto w = section_force(history, history.instants[0], span.beyond[k],
                                 span.stations[k]);
    // Half of one of 4000 slices may stand on the wrong side.
    EXPECT_NEAR(w.force.x() / bar.area(), sigma * span.positions[k] / 0.2,
                sigma * 0.5 / 4000);
  }
}

// Bar spinning about its centre: σ(x) = ½ρω²(L²/4 − x²).
TEST(BeamEstimate, SpinningBar) {
  const Bar bar{.start = -0.1, .end = 0.1};
  const std::vector groups{pin_group("A", -0.1), pin_group("B", 0.1)};
  auto history = pin_history(groups, {Vector3d::Zero(), Vector3d::Zero()});
  const double omega = 2000.0;
  history.instants[0].rigid.omega.z() = omega;
  const auto lines = pin_lines(bar.model(), bar.mass(), groups, history);
  const Span& span = lines.at(0).spans.at(0);
  const double peak = 0.5 * 7850.0 * omega * omega * 0.01;
  for (std::size_t k = 0; k < span.stations.size(); ++k) {
    const double x = span.positions[k] - 0.1;
    const auto w = section_force(history, history.instants[0], span.beyond[k],
                                 span.stations[k]);
    EXPECT_NEAR(w.force.x() / bar.area(), peak * (1.0 - x * x / 0.01),
                peak * 2.0 / 4000);
  }
  EXPECT_NEAR(stress_of(estimate_bar(bar, groups, history), "axial + bending"),
              peak, peak * 2.0 / 4000);
}

// Angular acceleration α of a free bar with couple forces at its ends:
// M(x) follows from the load q = −ρAαx: V = F − ∫q, a cubic in x.
TEST(BeamEstimate, AngularAccelerationBendsCubically) {
  const Bar bar{.start = -0.1, .end = 0.1};
  const std::vector groups{pin_group("A", -0.1), pin_group("B", 0.1)};
  const double F = 200.0, alpha = F * 0.2 / bar.mass().inertia_LCm(2, 2);
  auto history = pin_history(groups, {{0.0, -F, 0.0}, {0.0, F, 0.0}});
  history.instants[0].rigid.alpha.z() = alpha;
  const auto lines = pin_lines(bar.model(), bar.mass(), groups, history);
  const Span& span = lines.at(0).spans.at(0);
  const double q = 7850.0 * bar.area() * alpha;  // per x
  const double I_part = q * 2.0 * 1e-3 / 3.0 / (F * 0.2);
  ASSERT_NEAR(I_part, 1.0, 0.02);  // slender: I ≈ ρ A L³/12
  for (std::size_t k = 0; k < span.stations.size(); ++k) {
    const double x = span.positions[k] - 0.1;
    const auto w = section_force(history, history.instants[0], span.beyond[k],
                                 span.stations[k]);
    // Material beyond x turns about its own axis, too: I per length k² ρ A.
    const double h2 = (bar.height * bar.height + bar.width * 0.0) / 12.0;
    const double integral =
        (1e-3 - x * x * x) / 3.0 - x * (0.01 - x * x) / 2.0 + h2 * (0.1 - x);
    EXPECT_NEAR(w.moment.z(), F * (0.1 - x) - q * integral, F * 0.2 * 1e-3)
        << x;
  }
}

// Which side is summed must not matter: seen from the other side, the force
// is the opposite, for any loads in balance.
TEST(BeamEstimate, BothSidesOfASectionAgree) {
  const Bar bar{.start = -0.03, .end = 0.17, .slices = 57};
  const std::vector groups{pin_group("A", 0.0), pin_group("B", 0.06),
                           pin_group("C", 0.14)};
  auto history = pin_history(
      groups, {{100.0, 50.0, -20.0}, {-300.0, 20.0, 15.0}, Vector3d::Zero()});
  auto& instant = history.instants[0];
  instant.wrenches[0].moment = {1.0, -2.0, 0.5};
  instant.rigid = {.acceleration = {300.0, -500.0, 200.0},
                   .alpha = {100.0, 2000.0, -3000.0},
                   .omega = {10.0, 40.0, 30.0}};
  const loads::Wrench left = loads::residual(history, instant, bar.mass());
  instant.wrenches[2].force = -left.force;
  instant.wrenches[2].moment =
      -(left.moment - history.seats[2].p_LS.cross(left.force));
  const PartModel model = bar.model();
  const Vector3d n = Vector3d::UnitX();
  for (const double x : {0.02, 0.0811, 0.13}) {
    const Vector3d point(x, 0.0, 0.0);
    const auto wrench_beyond = [&](const Vector3d& normal) {
      const auto moments =
          moments_beyond(model.lumps, bar.mass(), normal, {point.dot(normal)});
      const Station station(bar.section(point), normal, moments[0]);
      return section_force(history, instant,
                           loads_beyond(history, groups, point, normal),
                           station);
    };
    const loads::Wrench a = wrench_beyond(n), b = wrench_beyond(-n);
    EXPECT_LT((a.force + b.force).norm(), 1e-10 * a.force.norm());
    EXPECT_LT((a.moment + b.moment).norm(), 1e-10 * a.moment.norm());
  }
}

TEST(BeamEstimate, SupportedPartGetsNoSectionForces) {
  const Bar bar{.start = -0.02, .end = 0.16};
  const std::vector groups{pin_group("A", 0.0), pin_group("B", 0.14)};
  const BeamEstimate e = estimate_bar(
      bar, groups, pin_history(groups, {{0.0, 0.0, 0.0}, {1118.0, 0.0, 0.0}}));
  EXPECT_EQ(stress_of(e, "axial + bending"), 0.0);
  EXPECT_GT(stress_of(e, "bearing pressure"), 0.0);
}

// A triangle of pins has three beams; a plane through a third pin is no
// section.
TEST(BeamEstimate, TriangularPartHasThreeLines) {
  std::vector groups{pin_group("D", 0.0, 7.5e-3), pin_group("C", 0.14, 7.5e-3),
                     pin_group("E", 0.07, 7.5e-3)};
  groups[2].cylinder.p_LC.y() = 0.06;
  const auto history = pin_history(groups, Forces(3, Vector3d::Zero()));
  const Bar bar{.start = -0.02, .end = 0.16};
  PartModel model = bar.model();
  model.section = [&bar](const Vector3d& point, const Vector3d&) {
    mesh::Section s = bar.section({0.0, 0.0, 0.0});
    s.centroid = point;
    return s;
  };
  const auto lines = pin_lines(model, bar.mass(), groups, history);
  ASSERT_EQ(lines.size(), 3u);
  const Span& DC = lines[0].spans.at(0);
  EXPECT_LT(DC.stations.size(), 25u);
  for (const double s : DC.positions) {
    EXPECT_GT(std::abs(s - 0.07), 7.5e-3);
    EXPECT_GT(s, 7.5e-3);
    EXPECT_LT(s, 0.14 - 7.5e-3);
  }
  EXPECT_EQ(lines[1].spans.at(0).stations.size(), 25u);
}

// A bar in a guide that travels, under a carriage that travels: it is bent
// where both stand, not at the middle of the wall that they share.
TEST(BeamEstimate, BarIsBentBetweenSlidesWhereTheyStand) {
  const Bar bar{.start = 0.0, .end = 0.4, .height = 10e-3};
  const double P = 100.0, half = 5e-3;
  const std::vector<std::pair<double, double>> places{
      {0.05, 0.10}, {0.08, 0.31}, {0.20, 0.35}};  // of guide and carriage
  loads::LoadHistory history;
  for (const char* const name : {"guide", "carriage"}) {
    history.seats.push_back({.name = name,
                             .group = "wall",
                             .kind = loads::SeatKind::kTraction,
                             .p_LS = {0.2, 0.0, 0.0},
                             .slide = loads::SlideWall{}});
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    loads::InstantLoad instant;
    instant.time = 0.5 * static_cast<double>(i);
    const Vector3d force(0.0, P, 0.0);
    const auto [guide, carriage] = places[i];
    for (const double at : {guide, carriage}) {
      const Vector3d way(at - 0.2, 0.0, 0.0);
      loads::ContactZone zone;
      zone.low[0] = way.x() - half;
      zone.high[0] = way.x() + half;
      instant.zones.push_back(zone);
      const Vector3d f = at == guide ? Vector3d(-force) : force;
      instant.wrenches.push_back({f, way.cross(f)});
    }
    instant.wrenches[0].moment.z() -= P * (carriage - guide);
    history.instants.push_back(std::move(instant));
  }
  const BeamStress worst =
      worst_of(estimate_bar(bar, {}, history), "axial + bending");
  EXPECT_NEAR(worst.stress, P * 0.23 / bar.section_modulus(), 1.0);
  EXPECT_EQ(worst.instant, 0.5);
  EXPECT_EQ(worst.where, "guide-carriage at 0 mm");
}

TEST(Formulas, EulerLoadOfTheRod) {
  const double d = 8e-3;
  const double I = std::numbers::pi * std::pow(d, 4) / 64.0;
  EXPECT_NEAR(euler_load(210e9, I, 0.26), 6165.0, 0.5);
}

// Bore 15 mm, wall 2 mm: hoop 4.31 p, radial −p.
TEST(Formulas, LameStressOfTheCylinderBody) {
  const double hoop = 4.3088;  // (9.5² + 7.5²)/(9.5² − 7.5²), five digits
  EXPECT_NEAR(lame_equivalent_stress(1e6, 7.5e-3, 9.5e-3),
              1e6 * std::sqrt(hoop * hoop + hoop + 1.0), 50.0);
}

}  // namespace
}  // namespace clevis::beam
