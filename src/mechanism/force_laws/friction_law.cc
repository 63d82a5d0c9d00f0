#include "mechanism/force_laws/friction_law.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace clevis::mechanism {
namespace {

struct Size {
  double value{}, slope{};
};

/// Kinetic friction, without the viscous part, and its derivative by speed.
Size kinetic_size(const FrictionLaw& law, double speed) {
  if (law.stribeck_speed <= 0.0) return {law.kinetic, 0.0};
  const double r = speed / law.stribeck_speed;
  const double more = (law.breakaway - law.kinetic) * std::exp(-r * r);
  return {law.kinetic + more, -2.0 * r / law.stribeck_speed * more};
}

FrictionEffort on_bristles(const FrictionLaw& law, int mode, double speed,
                           double bristle) {
  const Size size = kinetic_size(law, speed);
  // the mode times the speed is its size, smooth until the next turn
  const double pull = law.bristle_stiffness * mode / size.value;
  FrictionEffort f;
  f.bristle_decay = -pull * speed;
  f.bristle_rate = speed + f.bristle_decay * bristle;
  f.bristle_slope =
      1.0 - pull * bristle * (1.0 - speed * size.slope / size.value);
  f.own = -law.bristle_stiffness * bristle -
          law.bristle_damping * f.bristle_rate - law.viscous * speed;
  f.own_slope = -law.bristle_damping * f.bristle_slope - law.viscous;
  return f;
}

}  // namespace

FrictionEffort friction_effort(const FrictionLaw& law, int mode, double speed,
                               double bristle, double velocity_tolerance) {
  if (law.model == FrictionModel::kLuGre) {
    return on_bristles(law, mode, speed, bristle);
  }
  FrictionEffort f;
  if (law.model == FrictionModel::kRegularized) {
    const Size size = kinetic_size(law, speed);
    const double regular = std::max(law.regularizing_speed, velocity_tolerance);
    const double sense = std::tanh(speed / regular);
    f.per_load = -size.value * sense;
    f.per_load_slope =
        -size.slope * sense - size.value * (1.0 - sense * sense) / regular;
  } else if (std::abs(mode) == 2) {
    f.per_load = -0.5 * mode * law.breakaway;
    return f;
  } else if (std::abs(mode) == 1) {
    const Size size = kinetic_size(law, speed);
    f.per_load = -mode * size.value;
    f.per_load_slope = -mode * size.slope;
  } else {
    return f;  // a constraint holds it, or nothing does for a moment
  }
  f.own = -law.viscous * speed;
  f.own_slope = -law.viscous;
  return f;
}

FrictionEffort friction_along_tangent(const FrictionLaw& law,
                                      const FrictionEffort& at, double speed,
                                      double bristle) {
  FrictionEffort f = at;
  f.per_load += at.per_load_slope * speed;
  f.bristle_rate += at.bristle_slope * speed + at.bristle_decay * bristle;
  f.own += at.own_slope * speed;
  if (law.model == FrictionModel::kLuGre) {
    f.own -= (law.bristle_stiffness + law.bristle_damping * at.bristle_decay) *
             bristle;
  }
  return f;
}

}  // namespace clevis::mechanism
