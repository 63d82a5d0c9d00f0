#pragma once

#include <optional>

#include "part/material.h"

namespace clevis::beam {

/// A formula as its source prints it, or as it should be.
enum class Formula { kPublished, kCorrected };

/// Mass of the struck bar: left out, or moving along with the striker.
enum class StruckMass { kLeftOut, kMovesAlong };

/// A bar without inertia of its own, struck at one place.
struct StruckBar {
  double stiffness{};         ///< force per deflection of that place [N/m]
  double stress_per_force{};  ///< largest nominal stress per force [1/m²]
  double mass{};              ///< of the bar [kg]
  double mass_part{};         ///< κ at that place [1]: 33/140, 17/35, 1/3
};

/// Section of a bar in the plane of bending.
struct BarSection {
  double area{};             ///< [m²]
  double second_moment{};    ///< I [m⁴]
  double section_modulus{};  ///< W [m³]
};
/// Section of a round bar; diameter [m].
BarSection round_section(double diameter);

/// Struck at its free end, h the length [m]: 3 E I/h³. As published in
/// [RotorLine] E I/h³: the factor 3 of the deflection is missing.
StruckBar cantilever(const part::Material& material, const BarSection& section,
                     double length, Formula deflection = Formula::kCorrected);
/// Struck in the middle between hinges, l their distance [m]: 48 E I/l³.
StruckBar simple_beam(const part::Material& material, const BarSection& section,
                      double length);
/// Struck along its axis, the far end held, l the length [m]: E A/l.
StruckBar rod(const part::Material& material, const BarSection& section,
              double length);

/// A striker at the moment of touch.
struct Blow {
  double mass{};   ///< of the striker, reduced to the place [kg]
  double speed{};  ///< towards the bar [m/s]
  double force{};  ///< that goes on pushing the striker [N]; < 0 pulls it back
};

/// Deflection and stress of a bar under a blow by beam theory.
struct BarImpact {
  double static_deflection{},
      static_stress{};           ///< by the force alone [m], [Pa]
  std::optional<double> factor;  ///< β, dynamic over static; none without force
  double deflection{};           ///< largest [m]
  double stress{};               ///< largest [Pa]
};

/// Largest deflection and stress while the striker stays on the bar,
///     y = y_st + √(y_st² + m V²/k),   β = 1 + √(1 + m V²/(F y_st)),
/// the blow's energy being kept; with the bar's mass moving along only
/// m/(m + κ m_bar) of the kinetic energy is. Left out: waves and higher modes,
/// the contact's own give, rebound before the largest deflection.
/// Source: docs/theory.md, "Impact by beam theory".
BarImpact impact(const StruckBar& bar, const Blow& blow,
                 StruckMass struck_mass = StruckMass::kLeftOut);

/// Deflection [m] at a time [s] after the touch: exact for a bar without mass,
/// y_st (1 − cos ωt) + (V/ω) sin ωt, ω² = k/m.
double deflection_at(const StruckBar& bar, const Blow& blow, double time);

/// Largest speed at which impact() stays within a limit of stress [m/s]; 0 if
/// the force alone exceeds it. @param stress  the limit [Pa].
double largest_speed(const StruckBar& bar, const Blow& blow, double stress,
                     StruckMass struck_mass = StruckMass::kLeftOut);

/// Period of the bar alone with its mass reduced to the place, 2π √(κ m/k)
/// [s]; 1.4 % below the first bending period of a cantilever.
double first_period(const StruckBar& bar);

}  // namespace clevis::beam
