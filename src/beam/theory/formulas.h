#pragma once

namespace clevis::beam {

/// Critical force of a straight column hinged at both ends,
/// F = π² E I / l² [N].
///
/// Elastic, straight, uniform section. Young's modulus E [Pa], smallest second
/// moment I [m⁴], length l [m].
/// Source: docs/theory.md, "Buckling".
double euler_load(double youngs_modulus, double second_moment, double length);

/// Equivalent (von Mises) stress [Pa] at the bore of a thick cylinder under
/// internal pressure, ends free (σ_z = 0).
///
/// Lamé: σ_θ = p (b² + a²)/(b² − a²), σ_r = −p.
/// @param pressure  p [Pa]. @param inner  a [m].  @param outer  b > a [m].
double lame_equivalent_stress(double pressure, double inner, double outer);

/// √(σ² + 3τ²) [Pa] of a normal stress σ and a shear stress τ [Pa].
double equivalent_stress(double normal, double shear);

}  // namespace clevis::beam
