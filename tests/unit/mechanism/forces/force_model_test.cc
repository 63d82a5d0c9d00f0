#include "mechanism/forces/force_model.h"

#include <gtest/gtest.h>

#include "mechanism/forces/element_modes.h"
#include "mechanism/mass_matrix/centre_frame.h"
#include "support/reference_motions.h"

namespace clevis::mechanism {
namespace {

using Eigen::Vector3d;

/// A slider on a spring of 100 N/m, with a stop at 0.1 m.
class SpringAndStop : public ::testing::Test {
 protected:
  SpringAndStop()
      : definition_(with_elements()),
        frame_(frame_at_centres(definition_)),
        forces_(definition_, frame_) {}

  /// With the slider x [m] from its start.
  ForceState at(double x) const {
    Configuration placement = frame_.placement;
    placement[1].p += frame_.R_WP.transpose() * Vector3d(x, 0.0, 0.0);
    ForceState state = forces_.none();
    forces_.evaluate(0.0, placement, std::vector<Twist>(2), nullptr, state);
    return state;
  }

  MechanismDefinition definition_;
  SolvingFrame frame_;
  ForceModel forces_;

 private:
  static MechanismDefinition with_elements() {
    MechanismDefinition m = testing::sliders({2.0});
    StopLaw stop;
    stop.upper = 0.1;
    stop.contact.stiffness = 1e4;
    m.elements = {testing::on_joint(0, SpringLaw{.stiffness = 100.0}),
                  testing::on_joint(0, stop)};
    return m;
  }
};

// No state knows of another: the order in which they were evaluated is no
// matter.
TEST_F(SpringAndStop, StatesAreValues) {
  const ForceState near = at(0.05), far = at(0.2);
  EXPECT_NEAR(near.elements[0].effort, -5.0, 1e-12);
  EXPECT_NEAR(far.elements[0].effort, -20.0, 1e-12);
  Eigen::VectorXd values(event_count(forces_));
  put_event_values(forces_, far, values);
  EXPECT_NEAR(values[3], -0.1, 1e-15);  // beyond its upper end
  put_event_values(forces_, near, values);
  EXPECT_NEAR(values[3], 0.05, 1e-15);
}

// Modes are the elements' own, chosen by the state that is given.
TEST_F(SpringAndStop, ModesFollowTheStateGiven) {
  const ForceState far = at(0.2), near = at(0.05);
  choose_modes(far, forces_);
  EXPECT_EQ(modes(forces_), (std::vector<int>{0, 0, 0, 1}));
  EXPECT_NEAR(at(0.2).elements[1].effort, -1e4 * 0.1, 1e-9);
  choose_modes(near, forces_);
  EXPECT_EQ(modes(forces_), (std::vector<int>{0, 0, 0, 0}));
}

TEST_F(SpringAndStop, WrenchesAddUp) {
  choose_modes(at(0.2), forces_);
  std::vector<SpatialForce> wrenches(2);
  forces_.add_to(at(0.2), wrenches);
  const Vector3d on_slider = frame_.R_WP * wrenches[1].v;
  EXPECT_LT((on_slider - Vector3d(-20.0 - 1000.0, 0.0, 0.0)).norm(), 1e-9);
}

}  // namespace
}  // namespace clevis::mechanism
