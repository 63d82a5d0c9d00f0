#include "mechanism/dynamic_motion/fastest_rate.h"

#include <cmath>

#include <gtest/gtest.h>

#include "mechanism/integration/initial_state.h"
#include "support/reference_motions.h"

namespace clevis::mechanism {
namespace {

using testing::on_joint;
using testing::sliders;

// Two masses on springs: the stiffer one swings at sqrt(k / m).
TEST(FastestRate, NamesTheStifferSpringAndItsBody) {
  MechanismDefinition m = sliders({2.0, 0.5});
  m.elements.push_back(on_joint(0, SpringLaw{.stiffness = 100.0}));
  LineElement stiff = on_joint(1, SpringLaw{.stiffness = 5e9});
  stiff.name = "stiff";
  stiff.place = "scene.toml:7:1";
  m.elements.push_back(stiff);
  const SimulationSettings settings = testing::sampled(1.0, 2, 1e-8);
  DynamicModel model(m, settings);
  const Eigen::VectorXd y = model.equations.start(
      initial_state(m, model.frame, model.equations.system(), 1e-8).x);
  const FastestRate fastest = fastest_rate(model, 0.0, y);
  EXPECT_NEAR(fastest.rate, 1e5, 1e4);
  EXPECT_EQ(fastest.what, "body slider_1, by force stiff (scene.toml:7:1)");
}

}  // namespace
}  // namespace clevis::mechanism
