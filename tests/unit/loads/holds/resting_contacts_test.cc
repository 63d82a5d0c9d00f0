// Contacts that rest, and those that bounce, by how long they press.
#include "loads/holds/resting_contacts.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "support/free_linkages.h"

namespace clevis::loads {
namespace {

using mechanism::Instant;
using mechanism::testing::pin;
using mechanism::testing::uniform_bar;

constexpr double kStiffness = 1e4;  // [N m/rad]

/// A bar of 1 m on a pin of the ground, with a stop on its turn.
mechanism::MechanismDefinition bar_on_a_stop() {
  mechanism::MechanismDefinition m;
  m.bodies = {uniform_bar("bar", Eigen::Vector3d::Zero(), 0.0, 1.0)};
  m.joints = {pin("O", mechanism::kGround, 0, 0.0, 0.0)};
  m.dimension = mechanism::SpaceDimension::kPlanar;
  mechanism::LineElement stop;
  stop.name = "stop";
  stop.line.joint = 0;
  stop.law = mechanism::StopLaw{
      .lower = {}, .upper = 0.0, .contact = {.stiffness = kStiffness}};
  m.elements = {stop};
  return m;
}

/// It presses at `depths` above 0 [rad], at even times.
std::vector<Instant> pressing(const mechanism::MechanismDefinition& m,
                              const std::vector<double>& depths, double step) {
  std::vector<Instant> instants;
  for (const double depth : depths) {
    Instant& instant = instants.emplace_back();
    instant.t = step * static_cast<double>(instants.size() - 1);
    instant.bodies.push_back({.pose = m.bodies[0].placement});
    instant.joints.resize(1);
    auto& state = instant.elements.emplace_back();
    state.position = depth;
    state.effort = -kStiffness * std::max(depth, 0.0);
  }
  return instants;
}

std::vector<std::size_t> bounces_of(const std::vector<double>& depths,
                                    double step) {
  const auto m = bar_on_a_stop();
  const mechanism::Neighbours neighbours(m, 0);
  const auto instants = pressing(m, depths, step);
  std::vector<const Instant*> all;
  for (const Instant& instant : instants) all.push_back(&instant);
  return bounces(neighbours, 0, all);
}

// The bar by itself turns about its centre.
TEST(RestingContacts, RestThroughTenPeriods) {
  const auto m = bar_on_a_stop();
  const double inertia = m.bodies[0].mass_properties.inertia_LCm(2, 2);
  const double period =
      2.0 * std::numbers::pi * std::sqrt(inertia / kStiffness);
  const std::vector<double> depths{-1.0, 1e-3, 2e-3, 1e-3, -1.0,
                                   1e-3, 2e-3, 2e-3, 1e-3, -1.0};
  using Places = std::vector<std::size_t>;
  EXPECT_EQ(bounces_of(depths, 5.01 * period), Places{});
  EXPECT_EQ(bounces_of(depths, 4.99 * period), (Places{1, 2, 3}));
  EXPECT_EQ(bounces_of(depths, 3.33 * period), (Places{1, 2, 3, 5, 6, 7, 8}));
}

}  // namespace
}  // namespace clevis::loads
