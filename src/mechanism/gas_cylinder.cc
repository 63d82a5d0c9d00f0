#include "mechanism/gas_cylinder.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/errors.h"

namespace clevis::mechanism {
namespace {

double signal_at(const GasValve& valve, double t) {
  const auto next = std::ranges::upper_bound(valve.times, t);
  if (next == valve.times.begin()) return valve.signals.front();
  if (next == valve.times.end()) return valve.signals.back();
  const auto k = static_cast<std::size_t>(next - valve.times.begin());
  const double part =
      (t - valve.times[k - 1]) / (valve.times[k] - valve.times[k - 1]);
  return valve.signals[k - 1] +
         part * (valve.signals[k] - valve.signals[k - 1]);
}

Orifice opened(const GasValve& valve, double signal) {
  Orifice way = valve.orifice;
  way.conductance *= valve.leakage + (1.0 - valve.leakage) *
                                         valve_opening(signal, valve.smoothing);
  return way;
}

/// Flows of a chamber; their net is the inflow.
GasFlow net_flow(const GasCylinderLaw& law, const GasChamber& chamber, double t,
                 const GasState& gas, GasChamberState& state) {
  state.inflow = state.outflow = 0.0;
  if (!chamber.valve) return {};
  const double s = signal_at(*chamber.valve, t);
  const GasFlow in =
      orifice_flow(opened(*chamber.valve, s), law.gas, law.supply, gas);
  const GasFlow out =
      orifice_flow(opened(*chamber.valve, -s), law.gas, gas, law.environment);
  state.inflow = in.mass;
  state.outflow = out.mass;
  return {in.mass - out.mass, in.enthalpy - out.enthalpy};
}

}  // namespace

double chamber_volume(const GasChamber& chamber, double q) {
  return chamber.dead_volume +
         chamber.sense * chamber.area * (q - chamber.origin);
}

void start_gas(const GasCylinderLaw& law, const std::string& name,
               const std::string& place, double q, double* internal) {
  for (const GasChamber& chamber : law.chambers) {
    const double volume = chamber_volume(chamber, q);
    if (!(volume > 0.0)) {
      throw Error("K009", place,
                  fmt::format("chamber {} of {} starts with a volume of {:.6g} "
                              "mm^3, at {:.6g} mm",
                              chamber.name, name, 1e9 * volume, 1e3 * q),
                  "give it a larger dead_volume, or the origin at which it is "
                  "that");
    }
    const ChamberContent content =
        chamber_content(law.gas, chamber.start, volume);
    internal[0] = content.mass;
    internal[1] = content.energy;
    internal[2] = internal[3] = 0.0;
    internal += GasCylinderLaw::kStatesOfChamber;
  }
}

double gas_effort(const GasCylinderLaw& law, double t, double q, double rate,
                  const double* internal, GasInternals& rates,
                  GasChamberStates& states) {
  double effort = 0.0;
  double* rates_of_chamber = rates.data();
  for (std::size_t k = 0; k < law.chambers.size(); ++k) {
    const GasChamber& chamber = law.chambers[k];
    GasChamberState& state = states[k];
    state.volume = chamber_volume(chamber, q);
    state.mass = internal[0];
    const GasState gas =
        chamber_state(law.gas, {internal[0], internal[1]}, state.volume);
    state.pressure = gas.pressure;
    state.temperature = gas.temperature;
    state.taken = internal[2];
    state.released = internal[3];
    const GasFlow net = net_flow(law, chamber, t, gas, state);
    const double heat = chamber.wall_conductance *
                        (law.environment.temperature - gas.temperature);
    ChamberContent change =
        chamber_rates(gas, net, chamber.sense * chamber.area * rate, heat);
    if (chamber.heat == ChamberHeat::kIsothermal) {
      change.energy = law.gas.c_v() * chamber.start.temperature * change.mass;
    }
    rates_of_chamber[0] = change.mass;
    rates_of_chamber[1] = change.energy;
    rates_of_chamber[2] = state.inflow;
    rates_of_chamber[3] = state.outflow;
    effort += chamber.sense * chamber.area *
              (gas.pressure - law.environment.pressure);
    internal += GasCylinderLaw::kStatesOfChamber;
    rates_of_chamber += GasCylinderLaw::kStatesOfChamber;
  }
  return law.sections * effort;
}

void gas_scales(const GasCylinderLaw& law, const double* internal,
                double* scales) {
  for (const GasChamber& chamber : law.chambers) {
    const ChamberContent least =
        chamber_content(law.gas, chamber.start, chamber.dead_volume);
    scales[0] = std::max(least.mass, std::abs(internal[0]));
    scales[1] = std::max(least.energy, std::abs(internal[1]));
    scales[2] = scales[3] = scales[0];
    internal += GasCylinderLaw::kStatesOfChamber;
    scales += GasCylinderLaw::kStatesOfChamber;
  }
}

}  // namespace clevis::mechanism
