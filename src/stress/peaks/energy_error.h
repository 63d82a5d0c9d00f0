#pragma once

#include <span>

namespace clevis::stress {

/// Strain energy of one load with displacements of rising degree on one mesh.
struct EnergyValue {
  int dofs{};
  double energy{};  ///< [J]
};

/// Error of the last strain energy over it [1], from the last three: with the
/// limit E that makes log(E − E_i) a straight line over log(dofs) from one pair
/// to the next ([SzaboBabuska1991] §4.3); where the energies do not rise like
/// that, the last change. The relative error in the energy norm is its square
/// root.
/// @pre at least three values.
double strain_energy_error(std::span<const EnergyValue> sequence);

}  // namespace clevis::stress
