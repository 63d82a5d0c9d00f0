#pragma once

#include <vector>

namespace clevis::stress {

/// Support of one straight side of a wedge: nothing, both components, or one
/// of them, the tangential one left free of traction across it.
struct WedgeSide {
  enum class Hold { kNothing, kOneDirection, kBoth };
  Hold hold = Hold::kNothing;
  /// Of the held component, from the side's own direction (away from the
  /// tip), counter-clockwise: π/2 holds the normal one [rad].
  double direction = 0.0;
};

/// Kolosov's constant: 3 − 4ν in plane strain, (3 − ν)/(1 + ν) in plane stress
/// [1].
double kolosov_plane_strain(double poissons_ratio);
double kolosov_plane_stress(double poissons_ratio);

/// Williams' exponents of a wedge: displacements go like r^λ, stresses like
/// r^(λ − 1). All real parts in (0.05, 0.995), rising, each as often as its
/// multiplicity; empty if the stress at the tip is bounded (λ ≥ 1). To 1e-7.
/// Source: [Williams1952]; the general sides by the functions φ = a z^λ,
/// ψ = b z^λ of [Muskhelishvili] (docs/theory.md, "Singular zones").
/// @param angle  of the material at the tip, in (0, 2π] [rad].
/// @param first, second  sides at θ = 0 and θ = angle.
/// @param kolosov  of the plane state.
std::vector<double> wedge_exponents(double angle, const WedgeSide& first,
                                    const WedgeSide& second, double kolosov);

/// Smallest exponent of the displacement across the plane (mode III): π over
/// the angle, half of it if one side only is held [1].
/// @param angle  of the material at the tip [rad].
double antiplane_exponent(double angle, bool first_held, bool second_held);

}  // namespace clevis::stress
