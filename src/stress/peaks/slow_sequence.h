#pragma once

#include <span>

namespace clevis::stress {

/// A displacement by displacements of rising degree on one mesh, and the
/// strain energy of the same load.
struct DisplacementValue {
  int degree{};
  int dofs{};
  double value{};   ///< [m]
  double energy{};  ///< [J]
};

/// Error of the last displacement over it [1].
///
/// The largest of: what a geometric series of the last two changes would still
/// bring (peak_band), one and a half times the last change, and what a power of
/// the number of unknowns would, as at singular corners and where the material
/// hardly changes its volume (strain_energy_error, of the displacement and of
/// the energy, with half as much again for safety). Of two values four times
/// what they differ by: no ratio of changes is known, and where corners or a
/// nearly incompressible material slow them down more may be left. Of one: 1,
/// nothing is known.
double displacement_error(std::span<const DisplacementValue> sequence);

}  // namespace clevis::stress
