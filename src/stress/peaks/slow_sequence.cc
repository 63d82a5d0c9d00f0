#include "stress/peaks/slow_sequence.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "stress/peaks/energy_error.h"
#include "stress/peaks/peak_band.h"

namespace clevis::stress {
namespace {

constexpr double kUnknown = 1.0;

/// By a power of the number of unknowns, of a sequence that rises or falls.
double algebraic_error(std::vector<EnergyValue> values) {
  const auto n = values.size();
  if (values[n - 1].energy < values[n - 3].energy) {
    // The same distances from below.
    const double mirror = 2.0 * values[n - 1].energy;
    for (EnergyValue& value : values) value.energy = mirror - value.energy;
  }
  return strain_energy_error(values);
}

}  // namespace

double displacement_error(std::span<const DisplacementValue> sequence) {
  constexpr double kSafety = 1.5;
  constexpr double kLastChange = 1.5;  // coarse tetrahedra: 0.9 to 1.2 is left
  constexpr double kOfTwo = 4.0;
  if (sequence.size() < 2) return kUnknown;
  const double last = std::abs(sequence.back().value);
  if (last == 0.0) return 0.0;
  const double change =
      std::abs(last - std::abs(sequence[sequence.size() - 2].value));
  if (sequence.size() == 2) return kOfTwo * change / last;
  std::vector<SequenceValue> values;
  std::vector<EnergyValue> displacements, energies;
  for (const DisplacementValue& one : sequence) {
    values.push_back({one.degree, std::abs(one.value)});
    displacements.push_back({one.dofs, std::abs(one.value)});
    energies.push_back({one.dofs, one.energy});
  }
  const Band band = peak_band(values, kUnknown);
  return std::max({(band.high - band.value) / last, kLastChange * change / last,
                   kSafety * algebraic_error(displacements),
                   kSafety * strain_energy_error(energies)});
}

}  // namespace clevis::stress
