#include "mechanism/line_elements/gas_cylinder.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include <fmt/format.h>

#include "base/messages/errors.h"
#include "base/values/index.h"
#include "mechanism/element_base/line_force.h"
#include "numerics/curves/linear_table.h"

namespace clevis::mechanism {
namespace {

Orifice opened(const GasValve& valve, double signal) {
  Orifice way = valve.orifice;
  way.conductance *= valve.leakage + (1.0 - valve.leakage) *
                                         valve_opening(signal, valve.smoothing);
  return way;
}

/// Flow through a chamber's valve at an instant.
struct Flows {
  GasFlow in;   ///< from the supply
  GasFlow out;  ///< to the environment
};

Flows flows_of(const GasCylinderLaw& law, const GasChamber& chamber, double t,
               const GasState& supply, const GasState& gas) {
  if (!chamber.valve) return {};
  const GasValve& valve = *chamber.valve;
  const double s = numerics::linear_at(valve.times, valve.signals, t);
  return {orifice_flow(opened(valve, s), law.gas, supply, gas),
          orifice_flow(opened(valve, -s), law.gas, gas, law.environment)};
}

/// Pressure and temperature of chamber k, all that follows from its states.
GasState observe(const GasCylinderLaw& law, std::size_t k, double q,
                 const double* internal, GasChamberState& state) {
  const double* own = internal + k * GasCylinderLaw::kStatesOfChamber;
  state.volume = chamber_volume(law.chambers[k], q);
  state.mass = own[0];
  const GasState gas = chamber_state(law.gas, {own[0], own[1]}, state.volume);
  state.pressure = gas.pressure;
  state.temperature = gas.temperature;
  state.taken = own[2];
  state.released = own[3];
  state.inflow = state.outflow = 0.0;
  return gas;
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
                  "Give it a larger dead_volume, or the origin at which it is "
                  "that.");
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
  const std::size_t count = law.chambers.size();
  const std::size_t pistons = law.has_tank ? count - 1 : count;
  GasState supply = law.supply;
  if (law.has_tank)
    supply = observe(law, pistons, q, internal, states[pistons]);
  GasFlow from_tank;
  double effort = 0.0;
  for (std::size_t k = 0; k < pistons; ++k) {
    const GasChamber& chamber = law.chambers[k];
    const GasState gas = observe(law, k, q, internal, states[k]);
    const Flows flows = flows_of(law, chamber, t, supply, gas);
    states[k].inflow = flows.in.mass;
    states[k].outflow = flows.out.mass;
    from_tank.mass += law.sections * flows.in.mass;
    from_tank.enthalpy += law.sections * flows.in.enthalpy;
    const double heat = chamber.wall_conductance *
                        (law.environment.temperature - gas.temperature);
    ChamberContent change =
        chamber_rates(gas,
                      {flows.in.mass - flows.out.mass,
                       flows.in.enthalpy - flows.out.enthalpy},
                      chamber.sense * chamber.area * rate, heat);
    if (chamber.heat == ChamberHeat::kIsothermal) {
      change.energy = law.gas.c_v() * chamber.start.temperature * change.mass;
    }
    double* own = rates.data() + k * GasCylinderLaw::kStatesOfChamber;
    own[0] = change.mass;
    own[1] = change.energy;
    own[2] = flows.in.mass;
    own[3] = flows.out.mass;
    effort += chamber.sense * chamber.area *
              (gas.pressure - law.environment.pressure);
  }
  if (law.has_tank) {
    states[pistons].outflow = from_tank.mass;
    double* own = rates.data() + pistons * GasCylinderLaw::kStatesOfChamber;
    own[0] = -from_tank.mass;
    own[1] = -from_tank.enthalpy;
    own[2] = 0.0;
    own[3] = from_tank.mass;
  }
  return law.sections * effort;
}

double coupled_gas_effort(const GasCylinderLaw& law, double t, double rate,
                          const double* internal, GasInternals& rates,
                          GasChamberStates& states, GasInterface& interface) {
  interface.gas_q = interface.q + interface.rate * (t - interface.since);
  interface.gas_effort = gas_effort(law, t, interface.gas_q, interface.rate,
                                    internal, rates, states);
  const auto works = static_cast<std::size_t>(law.works_index());
  interface.work_on_mechanism = internal[works];
  interface.work_of_gas = internal[works + 1];
  rates[works] = interface.effort * rate;
  rates[works + 1] = interface.gas_effort * interface.rate;
  return interface.effort;
}

void communicate(GasInterface& interface, double t, double rate) {
  interface.since = t;
  interface.q = interface.gas_q;
  interface.rate = rate;
  interface.effort = interface.gas_effort;
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
  if (!law.is_coupled()) return;
  // works, as small as the energy of one chamber's dead volume
  const GasChamber& first = law.chambers.front();
  const ChamberContent least =
      chamber_content(law.gas, first.start, first.dead_volume);
  for (int i = 0; i < GasCylinderLaw::kWorks; ++i) {
    scales[i] = std::max(least.energy, std::abs(internal[i]));
  }
}

namespace {

class GasCylinder final : public LineForce {
 public:
  GasCylinder(const LineDefinition& definition, const GasCylinderLaw& law,
              const ReferenceFrame& frame)
      : LineForce(definition, frame), definition_(definition), law_(law) {}

  int internal_states() const override { return law_.internal_states(); }
  void start(const Configuration& x, double* own) override;
  void scales(const double* own, double* scales) const override {
    gas_scales(law_, own, scales);
  }
  double next_communication() const override {
    return law_.is_coupled() ? known_.since + law_.step
                             : LineForce::next_communication();
  }
  void communicate(double t, const ElementResponse& now) override {
    if (!law_.is_coupled()) return;
    known_ = *now.interface;
    mechanism::communicate(known_, t, now.rate);
  }
  bool has_smooth_effort() const override { return true; }

  std::optional<double> slow_stiffness(const LineAtRest& line) const override;

 protected:
  LineTangent tangent(const ElementState& state) const override;
  double law_effort(const ActingState& state,
                    ElementResponse& now) const override;

 private:
  double stiffness(
      const ElementState& state,
      const std::function<double(const GasChamber&)>& exponent) const;

  const LineDefinition& definition_;
  const GasCylinderLaw& law_;
  GasInterface known_{};  ///< since the last communication
};

void GasCylinder::start(const Configuration& x, double* own) {
  ElementResponse there;
  there.placed = PlacedJoint(line, x[index(line.a)], x[index(line.b)]);
  measure(there);
  start_gas(law_, definition_.name, definition_.place, there.q, own);
  known_ = {.since = -law_.step, .q = there.q};  // due at t = 0
}

/// @param exponent  of a chamber: how its pressure follows its volume [1].
/// @return [N/m].
double GasCylinder::stiffness(
    const ElementState& state,
    const std::function<double(const GasChamber&)>& exponent) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < state.chambers.size(); ++k) {
    const GasChamber& chamber = law_.chambers[k];
    const GasChamberState& gas = state.chambers[k];
    if (!(gas.volume > 0.0)) continue;  // a tank's area is 0
    sum += exponent(chamber) * gas.pressure * chamber.area * chamber.area /
           gas.volume;
  }
  return law_.sections * sum;
}

/// Of what the chambers hold, without flow and heat meanwhile.
LineTangent GasCylinder::tangent(const ElementState& state) const {
  return {stiffness(state,
                    [this](const GasChamber& chamber) {
                      return chamber.heat == ChamberHeat::kIsothermal
                                 ? 1.0
                                 : law_.gas.isentropic_exponent();
                    }),
          0.0};
}

/// Walls that conduct keep the temperature, a valve that is open the pressure.
std::optional<double> GasCylinder::slow_stiffness(
    const LineAtRest& line) const {
  const auto is_open = [&](const GasChamber& chamber) {
    return chamber.valve &&
           numerics::linear_at(chamber.valve->times, chamber.valve->signals,
                               line.t) != 0.0;
  };
  if (std::ranges::none_of(law_.chambers, [&](const GasChamber& chamber) {
        return chamber.heat == ChamberHeat::kConducting || is_open(chamber);
      })) {
    return std::nullopt;
  }
  return stiffness(line.state, [&](const GasChamber& chamber) {
    if (is_open(chamber)) return 0.0;
    return chamber.heat == ChamberHeat::kInsulated
               ? law_.gas.isentropic_exponent()
               : 1.0;
  });
}

double GasCylinder::law_effort(const ActingState& state,
                               ElementResponse& now) const {
  const double* own = state.internal + internal;
  GasInternals rates{};
  GasChamberStates chambers;
  if (law_.is_coupled()) now.interface = known_;
  const double found =
      law_.is_coupled()
          ? coupled_gas_effort(law_, state.t, now.rate, own, rates, chambers,
                               *now.interface)
          : gas_effort(law_, state.t, now.q, now.rate, own, rates, chambers);
  std::copy_n(rates.begin(), now.internal_rates.size(),
              now.internal_rates.begin());
  const auto count = static_cast<std::ptrdiff_t>(law_.chambers.size());
  now.chambers.assign(chambers.begin(), chambers.begin() + count);
  return found;
}

}  // namespace

ElementProperties properties(const GasCylinderLaw& law) {
  ElementProperties result{.type = "gas_cylinder",
                           .actuation = Actuation::kMachine,
                           .may_be_pressure = true,
                           .gas = &law};
  for (const GasChamber& chamber : law.chambers) {
    if (!chamber.valve) continue;
    const std::vector<double>& times = chamber.valve->times;
    result.breaks.insert(result.breaks.end(), times.begin(), times.end());
  }
  return result;
}

std::unique_ptr<ActingElement> place(const LineDefinition& definition,
                                     const GasCylinderLaw& law,
                                     const ReferenceFrame& frame) {
  return std::make_unique<GasCylinder>(definition, law, frame);
}

}  // namespace clevis::mechanism
