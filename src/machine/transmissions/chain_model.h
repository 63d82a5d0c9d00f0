#pragma once

#include <vector>

namespace clevis::machine {

/// Frequencies of masses one behind the other, joined by springs: a drive
/// train with the inertia of its wheels, all seen from the output.
struct ChainModel {
  std::vector<double> resonances;      ///< [Hz], all free; ascending
  std::vector<double> antiresonances;  ///< [Hz], the first mass held
};

/// @param inertias     n ≥ 2, all ≥ 0, the first and the last > 0; [kg m²] or
///   [kg]. What has none passes its load on.
/// @param compliances  n − 1 between them, ≥ 0; [rad/(N m)] or [m/N]. What
///   does not yield joins its two masses.
ChainModel chain_model(const std::vector<double>& inertias,
                       const std::vector<double>& compliances);

}  // namespace clevis::machine
