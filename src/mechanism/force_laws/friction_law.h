#pragma once

#include "mechanism/force_laws/guide.h"

namespace clevis::mechanism {

enum class FrictionModel { kCoulomb, kRegularized, kLuGre };

/// Dry friction with stick. Kinetic effort at speed v:
/// kinetic + (breakaway − kinetic) exp(−(v/stribeck)²) + viscous v.
struct FrictionLaw {
  FrictionModel model = FrictionModel::kCoulomb;
  double breakaway{}, kinetic{};  ///< [N] or [N m]
  double viscous{};               ///< [N s/m] or [N m s/rad]
  double stribeck_speed{};        ///< [m/s] or [rad/s]; 0: kinetic at once
  double regularizing_speed{};    ///< of tanh(v/v_c); regularized only
  double bristle_stiffness{}, bristle_damping{};  ///< LuGre [Canudas1995]
  /// Breakaway and kinetic are per newton of the joint's force across its axis:
  /// [1], or [m] where the joint turns.
  bool follows_reaction = false;
  Guide guide;  ///< whose ends press, of a slide; follows_reaction only
};

/// Friction of a line at a speed, with derivatives: effort = load × per_load +
/// own [N] or [N m], the load being 1 or the reaction that the friction
/// follows [N].
struct FrictionEffort {
  double per_load{}, own{};
  double per_load_slope{}, own_slope{};  ///< by the speed
  double bristle_rate{};                 ///< LuGre
  double bristle_slope{};                ///< of that rate, by the speed
  double bristle_decay{};                ///< of that rate, by the bristle
};

/// @param mode  0 sticks, ±1 slips in that sense, ±2 gives its most against it,
///   3 is left out. @param bristle  LuGre: its deflection
///   [m] or [rad].
/// @param speed  of the line [m/s] or [rad/s].
/// @param velocity_tolerance  lower bound of the regularizing speed [m/s] or
/// [rad/s].
FrictionEffort friction_effort(const FrictionLaw& law, int mode, double speed,
                               double bristle, double velocity_tolerance = 0.0);

/// The same by the tangent at another speed [m/s] or [rad/s] and bristle [m] or
/// [rad].
FrictionEffort friction_along_tangent(const FrictionLaw& law,
                                      const FrictionEffort& at, double speed,
                                      double bristle);

}  // namespace clevis::mechanism
