#include "report/parts/probe_quantities.h"

#include "part/part_definition.h"

namespace clevis::report {
namespace {

using assessment::ProbeResult;

/// A value of a probe that is a displacement, or of one that is a stress.
auto of_probe(double ProbeResult::*member, bool displacement) {
  return [=](const ProbeResult& probe) {
    return is_displacement(probe) == displacement ? std::optional(probe.*member)
                                                  : std::nullopt;
  };
}

}  // namespace

const Quantities<ProbeResult>& probe_quantities() {
  using S = ProbeResult;
  static const Quantities<S> rows{
      quantity<S>({"name", "/name"}, &S::name),
      quantity<S>({"quantity", "/quantity"}, &S::quantity),
      quantity<S>({"probe_stress", "/value_MPa", "MPa", "", kStressRule},
                  of_probe(&S::value, false)),
      quantity<S>({"probe_stress_low", "/band_MPa/0", "MPa"},
                  of_probe(&S::band_low, false)),
      quantity<S>({"probe_stress_high", "/band_MPa/1", "MPa"},
                  of_probe(&S::band_high, false)),
      quantity<S>({"probe_displacement", "/value_mm", "mm", "", kLengthRule},
                  of_probe(&S::value, true)),
      quantity<S>({"probe_displacement_low", "/band_mm/0", "mm"},
                  of_probe(&S::band_low, true)),
      quantity<S>({"probe_displacement_high", "/band_mm/1", "mm"},
                  of_probe(&S::band_high, true)),
  };
  return rows;
}

bool is_displacement(const ProbeResult& probe) {
  return part::is_displacement(probe.quantity);
}

}  // namespace clevis::report
