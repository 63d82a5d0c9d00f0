#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beam/theory/impact.h"
#include "machine/devices/ejector.h"

namespace clevis::beam {

/// Which formulas of [RotorLine] stand as printed.
struct EjectorFormulas {
  Formula deflection = Formula::kCorrected;  ///< y_st/F: h³/(E I), or a third
  Formula speed = Formula::kCorrected;       ///< V: 2 V_B, or V_B
  /// Work of magnet and spring: F0 S (1 − S/l) and (S_D − S_D0)², or F0 S (1 −
  /// S/(2l)) and (S_D0 + S_D)² − S_D0².
  Formula drive = Formula::kCorrected;
};

/// Mass, force and speed of the lever at the workpiece.
struct EjectorDrive {
  double pusher_mass{};   ///< J_C/CB² [kg]
  double pusher_force{};  ///< of magnet and spring at the blow [N]
  double energy{};  ///< of the lever then [J]; ≤ 0: it does not get there
  /// V_B [m/s]; none where the energy is not positive.
  std::optional<double> pusher_speed;
};

/// (3)–(5). Magnet: F0 (1 − s/l) over the armature's travel s.
EjectorDrive ejector_drive(const machine::EjectorDefinition& ejector,
                           Formula formula = Formula::kCorrected);

StruckBar ejector_workpiece(const machine::EjectorDefinition& ejector,
                            Formula deflection = Formula::kCorrected);

/// The blow on the workpiece; none if the pusher does not reach it.
std::optional<BarImpact> ejector_impact(
    const machine::EjectorDefinition& ejector, const EjectorFormulas& formulas,
    StruckMass struck_mass = StruckMass::kLeftOut);

/// (6) with the numbers put in: stress [Pa]. As printed J_C stands twice
/// (I-6), so that a dimension of 1/(kg m²) is left and SI numbers are taken
/// for what they are; corrected it is ejector_impact() with V = 2 V_B and
/// y_st = h³/(E I) for both. None if the bracket is not positive, or nothing
/// pushes at the blow: F stands under the root and before it.
std::optional<double> strength_condition(
    const machine::EjectorDefinition& ejector, Formula formula);

/// One row of the comparison of formulas.
struct EjectorVariant {
  std::string name;
  double speed{};  ///< of the blow that it takes [m/s]
  std::optional<BarImpact> impact;
};
std::vector<EjectorVariant> ejector_variants(
    const machine::EjectorDefinition& ejector);

/// Largest values, the others as they are, with which the corrected stress
/// stays within yield strength / safety factor; the rod's mass left out. None:
/// any will do within what was tried, 0: none.
struct EjectorLimits {
  double stress{};  ///< allowed [Pa]
  double speed{};   ///< of the pusher, with its force as it is [m/s]
  std::optional<double> magnet_force;  ///< up to 1000 times as it is [N]
  std::optional<double> travel;        ///< up to the magnet's range [m]
  std::optional<double> range;         ///< up to 1000 times the travel [m]
};
EjectorLimits ejector_limits(const machine::EjectorDefinition& ejector);

}  // namespace clevis::beam
