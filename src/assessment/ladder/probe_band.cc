#include "assessment/ladder/probe_band.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "assessment/places/meeting_places.h"

namespace clevis::assessment {

template <int dim>
stress::Band probe_band(const DegreeLadder<dim>& ladder, std::size_t index,
                        const std::string& load_case,
                        const std::string& quantity, double tolerance) {
  std::vector<stress::SequenceValue> sequence;
  std::vector<double> values;
  for (std::size_t k = 0; k < ladder.sequence.size(); ++k) {
    values.push_back(ladder.probes[k][index].value);
    sequence.push_back({ladder.sequence[k].degree, values.back()});
  }
  auto band = stress::peak_band(sequence, tolerance);
  const double doubt = kErrorOfJump * ladder.probes.back()[index].jump;
  band.low = std::min(band.low, band.value - doubt);
  band.high = std::max(band.high, band.value + doubt);
  if (part::is_displacement(quantity)) {
    const double error = std::abs(band.value) *
                         ladder.deflections.probe_error(load_case, values);
    band.low = band.value - error;
    band.high = band.value + error;
  }
  return band;
}

template <int dim>
bool probes_are_within(const DegreeLadder<dim>& ladder, const PartJob& job,
                       double tolerance) {
  const double allowed = tolerance * ladder.level.member.peak;
  std::size_t index = 0;
  for (const auto& load_case : job.part.cases) {
    for (const auto& probe : load_case.probes) {
      const auto band = probe_band(ladder, index++, load_case.name,
                                   probe.quantity, tolerance);
      const double reach =
          std::max(band.high - band.value, band.value - band.low);
      if (!part::is_displacement(probe.quantity) && reach > allowed)
        return false;
    }
  }
  return true;
}

#define CLEVIS_INSTANTIATE(dim)                                                \
  template stress::Band probe_band<dim>(const DegreeLadder<dim>&, std::size_t, \
                                        const std::string&,                    \
                                        const std::string&, double);           \
  template bool probes_are_within<dim>(const DegreeLadder<dim>&,               \
                                       const PartJob&, double);
CLEVIS_INSTANTIATE(2)
CLEVIS_INSTANTIATE(3)
#undef CLEVIS_INSTANTIATE

}  // namespace clevis::assessment
