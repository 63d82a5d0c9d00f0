#pragma once

namespace clevis::beam {

/// Critical force of a straight column hinged at both ends,
/// F = π² E I / l² [N].
///
/// Elastic, straight, uniform section; I is the smallest second moment.
/// Source: docs/theory.md, "Buckling".
double euler_load(double youngs_modulus, double second_moment, double length);

/// Equivalent (von Mises) stress [Pa] at the bore of a thick cylinder under
/// internal pressure, ends free (σ_z = 0).
///
/// Lamé: σ_θ = p (b² + a²)/(b² − a²), σ_r = −p.
/// @param inner  a [m].  @param outer  b > a [m].
double lame_equivalent_stress(double pressure, double inner, double outer);

/// √(σ² + 3τ²) [Pa].
double equivalent_stress(double normal, double shear);

}  // namespace clevis::beam
