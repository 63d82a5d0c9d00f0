// Counts what the C library's allocator is asked for, by standing in for it.
#include <cstddef>

#include <gtest/gtest.h>

#include "mechanism/events/stick_slip.h"
#include "mechanism/integration/initial_state.h"
#include "mechanism/integration/motion_integrator.h"
#include "mechanism/mass_matrix/centre_frame.h"
#include "support/benchmark_mechanisms.h"
#include "support/reference_motions.h"

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && \
    defined(__GLIBC__)
#define CLEVIS_COUNTS_ALLOCATIONS
#endif

#ifdef CLEVIS_COUNTS_ALLOCATIONS
namespace {
long allocations = 0;
}

extern "C" {
void* __libc_malloc(std::size_t size);
void* malloc(std::size_t size) {
  ++allocations;
  return __libc_malloc(size);
}
}

namespace clevis::mechanism {
namespace {

/// Allocations of the steps from `skip` on.
long allocations_of_steps(const MechanismDefinition& definition,
                          numerics::IntegratorChoice choice, int skip,
                          int steps) {
  const SolvingFrame frame = frame_at_centres(definition);
  ForwardDynamics dynamics(definition, frame, 1e-8, 1.0);
  EquationsOfMotion& equations = dynamics.equations();
  const InitialState initial =
      initial_state(definition, frame, equations.system(), 1e-8);
  Eigen::VectorXd y = equations.start(initial.x);
  y.segment(equations.layout().velocity_index(), initial.velocities.size()) =
      initial.velocities;
  dynamics.projection().project(0.0, y);
  StickSlip(dynamics).choose_modes(0.0, y);
  equations.accept(0.0, y);
  MotionIntegrator integrator(definition, frame, dynamics, choice);
  integrator.restart(0.0, y, 0.0);
  long before = 0;
  for (int i = 0; i < skip + steps; ++i) {
    if (i == skip) before = allocations;
    EXPECT_TRUE(integrator.step(1e9));
    y = integrator.y();
    dynamics.projection().project(integrator.t(), y);
    equations.accept(integrator.t(), y);
    integrator.correct(y);
  }
  return allocations - before;
}

MechanismDefinition on_gas() {
  GasChamber chamber;
  chamber.area = 2e-4;
  chamber.dead_volume = 1e-5;
  chamber.start = {101325.0, 293.15};
  chamber.valve = GasValve{.orifice = {.conductance = 1.5e-9},
                           .times = {0.0, 0.02},
                           .signals = {0.0, 1.0}};
  GasCylinderLaw law;
  law.supply.pressure = 2e5;
  law.chambers = {chamber};
  MechanismDefinition m = testing::sliders({0.6});
  m.elements = {testing::on_joint(0, law)};
  return m;
}

MechanismDefinition on_a_motor() {
  MotorLaw law;
  law.resistance = 1.0;
  law.inductance = 1e-3;
  law.flux = 0.02;
  law.rotor_inertia = 1e-3;
  law.times = {0.0};
  law.volts = {5.0};
  MechanismDefinition m = testing::simple_pendulum(0.5);
  m.elements = {testing::on_joint(0, law)};
  return m;
}

// Its steps need new Jacobians.
TEST(Allocation, NoneInAStepThatLinearises) {
  EXPECT_EQ(
      allocations_of_steps(testing::governor(),
                           numerics::IntegratorChoice::kImplicit, 30, 100),
      0);
}

TEST(Allocation, NoneInAStep) {
  for (const numerics::IntegratorChoice choice :
       {numerics::IntegratorChoice::kExplicit,
        numerics::IntegratorChoice::kImplicit}) {
    EXPECT_EQ(
        allocations_of_steps(testing::simple_pendulum(0.5), choice, 2, 20), 0);
    EXPECT_EQ(
        allocations_of_steps(testing::spatial_slider_crank(), choice, 2, 20),
        0);
    EXPECT_EQ(allocations_of_steps(testing::pulled(testing::bristles()), choice,
                                   2, 20),
              0);
    EXPECT_EQ(
        allocations_of_steps(testing::two_window_four_bar(), choice, 2, 20), 0);
    EXPECT_EQ(allocations_of_steps(on_gas(), choice, 2, 20), 0);
    EXPECT_EQ(allocations_of_steps(on_a_motor(), choice, 2, 20), 0);
    EXPECT_EQ(
        allocations_of_steps(
            testing::pulled({.breakaway = 1.5, .kinetic = 1.0}), choice, 2, 5),
        0);
  }
}

}  // namespace
}  // namespace clevis::mechanism
#endif
