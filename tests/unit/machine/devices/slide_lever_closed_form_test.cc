#include "machine/devices/slide_lever_closed_form.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "mechanism/simulate.h"
#include "support/landing_gear.h"

namespace clevis::mechanism {
namespace {

using namespace testing;
using Eigen::Vector2d;

constexpr machine::SlideLever kLever{
    .FD = kFD, .ED = kED, .DC = kDC, .EC = kEC, .AD = kAD, .DD1 = 0.210};

TEST(SlideLeverClosedForm, CorrectedIsTheSimulatedPoint) {
  const Motion motion = simulate(landing_gear(), {.duration = 2.0});
  for (const Instant& at : motion.instants) {
    const auto p = machine::slide_lever_position(
        kLever, at.drives[0].position, machine::SlideLeverForm::kCorrected);
    EXPECT_NEAR(p.DC / kDC, 1.0, 1e-9);
    EXPECT_LT((p.C - at.joints[kC].p_WJ.head<2>()).norm(), 1e-12);
    // velocity of C by (2.16), corrected
    const Vector2d v = p.C_rate * at.drives[0].rate;
    EXPECT_LT((v - at.bodies[kBodyBC].v_WLo.head<2>()).norm(), 1e-12);
  }
}

TEST(SlideLeverClosedForm, PublishedBreaksTheLink) {
  const double lx[] = {0.16, 0.21, 0.26}, DC[] = {92.1, 151.5, 201.1};
  const Vector2d C[] = {{43.69, -21.12}, {132.68, 133.04}, {104.81, 231.60}};
  for (int i = 0; i < 3; ++i) {
    const auto p = machine::slide_lever_position(
        kLever, lx[i], machine::SlideLeverForm::kPublished);
    EXPECT_NEAR(1e3 * p.DC, DC[i], 0.051);
    EXPECT_LT((1e3 * p.C - C[i]).cwiseAbs().maxCoeff(), 0.0051);
  }
}

TEST(SlideLeverClosedForm, AnglesOfTheSource) {
  const double lx[] = {0.16, 0.21, 0.26}, q3[] = {25.622, 78.827, 138.963};
  constexpr double degree = std::numbers::pi / 180.0;
  for (int i = 0; i < 3; ++i) {
    const auto p = machine::slide_lever_position(
        kLever, lx[i], machine::SlideLeverForm::kCorrected);
    EXPECT_NEAR(p.q3 / degree, q3[i], 0.51e-3);
    EXPECT_NEAR(p.q5 / degree, 73.214, 0.51e-3);
  }
}

// The rates of both forms are the derivatives of their own positions.
TEST(SlideLeverClosedForm, RatesAreDerivatives) {
  constexpr double h = 1e-6;
  for (const auto form : {machine::SlideLeverForm::kPublished,
                          machine::SlideLeverForm::kCorrected}) {
    const auto at = [form](double lx) {
      return machine::slide_lever_position(kLever, lx, form);
    };
    const Vector2d rate = (at(0.2 + h).C - at(0.2 - h).C) / (2.0 * h);
    EXPECT_LT((at(0.2).C_rate - rate).norm(), 1e-7);
  }
}

}  // namespace
}  // namespace clevis::mechanism
