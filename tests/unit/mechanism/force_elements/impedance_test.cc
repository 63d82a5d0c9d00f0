#include "mechanism/force_elements/impedance.h"

#include <cmath>

#include <gtest/gtest.h>

#include "mechanism/simulate.h"
#include "support/reference_motions.h"

namespace clevis::mechanism {
namespace {

using Eigen::Vector3d;
using testing::free_body;
using testing::sampled;

// x'' + 2 D w (x' − v₀) + w² (x − x₀) = 0 about a target that moves evenly
// (natural ends: the spline is the straight line), and with absolute damping.
TEST(Impedance, FollowsAMovingTarget) {
  for (const bool absolute : {false, true}) {
    MechanismDefinition m = free_body();
    ImpedanceElement impedance;
    impedance.point.body = 0;
    const Vector3d start(0.1, 0.2, 0.3), speed(0.2, -0.1, 0.3);
    for (int k = 0; k < 3; ++k) {
      impedance.path_W[static_cast<std::size_t>(k)] =
          numerics::interpolating_spline({0.0, 1.0},
                                         {start[k], start[k] + speed[k]},
                                         numerics::SplineEnds::kNatural);
    }
    impedance.stiffness = 200.0;
    impedance.damping = 8.0;
    impedance.damps_absolute = absolute;
    m.elements = {impedance};
    const Motion motion = simulate(m, sampled(1.0, 11, 1e-10));
    const double decay = 2.0, w = std::sqrt(100.0 - 4.0);
    // what the target's speed makes the body lag behind in the end
    const double lag = absolute ? 8.0 / 200.0 : 0.0;
    for (const Instant& i : motion.instants) {
      const double e = std::exp(-decay * i.t), c = std::cos(w * i.t),
                   s = std::sin(w * i.t);
      // x − x₀ = −v₀ (lag − e^(−d t)(lag cos − (1 − d lag)/w sin)) by x(0),
      // x'(0)
      const double off = -lag + e * (lag * c + (decay * lag - 1.0) / w * s);
      const Vector3d x = start + speed * (i.t + off);
      EXPECT_LT((i.bodies[0].pose.p_WL - x).norm(), 1e-9);
    }
  }
}

}  // namespace
}  // namespace clevis::mechanism
