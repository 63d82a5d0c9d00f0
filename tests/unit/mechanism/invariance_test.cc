#include <algorithm>

#include <gtest/gtest.h>

#include "mechanism/simulate.h"
#include "support/landing_gear.h"

namespace clevis::mechanism {
namespace {

using Eigen::Matrix3d;
using namespace testing;

constexpr double kSame = 1e-10;

MechanismDefinition loaded() {
  MechanismDefinition m = landing_gear();
  m.elements = {wheel_load(0.14)};
  m.drives[0].duration = 0.1;
  return m;
}

double force_scale(const Instant& at) {
  double scale = 0.0;
  for (const auto& r : at.joints) scale = std::max(scale, r.f_W.norm());
  return scale;
}

void expect_same_but_moved(const MechanismDefinition& m, const Matrix3d& R,
                           const Vector3d& p) {
  const SimulationSettings settings{.duration = 0.1, .instants = 21};
  const Motion here = simulate(m, settings);
  const Motion there = simulate(moved(m, R, p), settings);
  for (std::size_t i = 0; i < here.instants.size(); ++i) {
    const Instant& a = here.instants[i];
    const Instant& b = there.instants[i];
    const double scale = force_scale(a);
    for (std::size_t j = 0; j < a.joints.size(); ++j) {
      EXPECT_LT((R * a.joints[j].f_W - b.joints[j].f_W).norm(), kSame * scale);
      EXPECT_LT((R * a.joints[j].t_W - b.joints[j].t_W).norm(), kSame * scale);
      EXPECT_LT((R * a.joints[j].p_WJ + p - b.joints[j].p_WJ).norm(), kSame);
      EXPECT_EQ(a.joints[j].unique, b.joints[j].unique);
    }
    for (std::size_t k = 0; k < a.bodies.size(); ++k) {
      EXPECT_LT((R * a.bodies[k].a_WLo - b.bodies[k].a_WLo).norm(),
                kSame * (1.0 + a.bodies[k].a_WLo.norm()));
    }
    EXPECT_NEAR(a.drives[0].effort, b.drives[0].effort, kSame * scale);
  }
}

TEST(Invariance, TranslationOfTheWorld) {
  expect_same_but_moved(loaded(), Matrix3d::Identity(), {3.0, -2.0, 1.5});
}

TEST(Invariance, RotationInThePlane) {
  expect_same_but_moved(loaded(), turned(1.234), {0.1, 0.2, 0.0});
}

TEST(Invariance, RotationOutOfThePlane) {
  const Matrix3d R =
      Eigen::AngleAxisd(2.1, Vector3d(1.0, 2.0, -0.5).normalized())
          .toRotationMatrix();
  expect_same_but_moved(loaded(), R, {0.5, 0.0, -0.3});
}

TEST(Invariance, RotationTakenAsSpatial) {
  MechanismDefinition m = loaded();
  m.dimension = SpaceDimension::kSpatial;
  const Matrix3d R =
      Eigen::AngleAxisd(0.7, Vector3d(-1.0, 0.4, 0.5).normalized())
          .toRotationMatrix();
  expect_same_but_moved(m, R, {0.0, 0.3, 0.1});
}

// Everything a hundred times larger under its own weight: times in ratio √λ,
// forces ρ g λ³.
TEST(Invariance, ScaleOfTheMechanism) {
  constexpr double lambda = 100.0;
  const MechanismDefinition small = landing_gear();
  MechanismDefinition large = small;
  for (BodyDefinition& body : large.bodies) {
    body.placement.p_WL *= lambda;
    body.mass_properties.mass *= std::pow(lambda, 3);
    body.mass_properties.p_LCm *= lambda;
    body.mass_properties.inertia_LCm *= std::pow(lambda, 5);
  }
  for (JointDefinition& joint : large.joints) {
    joint.frame_a.p_LJ *= lambda;
    joint.frame_b.p_LJ *= lambda;
  }
  large.drives[0].from *= lambda;
  large.drives[0].to *= lambda;
  large.drives[0].duration *= std::sqrt(lambda);
  const Motion a = simulate(small, {.duration = 2.0, .instants = 11});
  const Motion b =
      simulate(large, {.duration = 2.0 * std::sqrt(lambda), .instants = 11});
  for (std::size_t i = 0; i < a.instants.size(); ++i) {
    const double scale = force_scale(a.instants[i]);
    for (std::size_t j = 0; j < a.instants[i].joints.size(); ++j) {
      EXPECT_LT((a.instants[i].joints[j].f_W -
                 b.instants[i].joints[j].f_W / std::pow(lambda, 3))
                    .norm(),
                kSame * scale);
    }
  }
}

// The frame of a body is a matter of choice: shift FE2's far away.
TEST(Invariance, OriginOfABodyFrame) {
  const MechanismDefinition m = loaded();
  MechanismDefinition shifted = m;
  const Vector3d shift(4.0, -7.0, 0.0);
  BodyDefinition& body = shifted.bodies[kFE2];
  body.placement.p_WL += body.placement.R_WL * shift;
  body.mass_properties.p_LCm -= shift;
  shifted.joints[kE].frame_b.p_LJ -= shift;
  shifted.joints[kCylinder].frame_b.p_LJ -= shift;
  const SimulationSettings settings{.duration = 0.1, .instants = 21};
  const Motion a = simulate(m, settings), b = simulate(shifted, settings);
  for (std::size_t i = 0; i < a.instants.size(); ++i) {
    const double scale = force_scale(a.instants[i]);
    for (std::size_t j = 0; j < a.instants[i].joints.size(); ++j) {
      EXPECT_LT(
          (a.instants[i].joints[j].f_W - b.instants[i].joints[j].f_W).norm(),
          kSame * scale);
    }
  }
}

}  // namespace
}  // namespace clevis::mechanism
