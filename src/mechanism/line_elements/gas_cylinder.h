#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mechanism/element_base/element_properties.h"
#include "mechanism/element_base/element_state.h"
#include "mechanism/element_base/force_line.h"
#include "mechanism/force_laws/gas.h"

namespace clevis::mechanism {

class ActingElement;
struct ReferenceFrame;

/// A valve with three ways: a signal s > 0 opens from the supply into the
/// chamber, s < 0 from the chamber to the environment.
struct GasValve {
  Orifice orifice;          ///< of either way, fully open
  double leakage = 1e-6;    ///< conductance when shut, over that when open
  double smoothing = 0.01;  ///< see valve_opening()
  std::vector<double> times, signals;  ///< [s], −1 to 1; linear between
};

enum class ChamberHeat { kInsulated, kConducting, kIsothermal };

/// One side of a piston.
struct GasChamber {
  std::string name;
  double sense = 1.0;    ///< 1: pushes a and b apart; −1: pulls them together
  double area{};         ///< of the piston [m²]
  double dead_volume{};  ///< at `origin` [m³]
  double origin{};       ///< of the line's coordinate [m]
  GasState start;
  ChamberHeat heat = ChamberHeat::kInsulated;
  double wall_conductance{};      ///< to the environment [W/K]
  std::optional<GasValve> valve;  ///< sealed without
};

/// Gas on the sides of one or more pistons that move together; `sections`
/// alike, whose forces add.
/// Effort on b: sections Σ sense (p − p_environment) area, the faces' other
/// sides and the rod being in the environment.
struct GasCylinderLaw {
  static constexpr int kMostChambers = 8;
  /// Of a chamber: mass, energy, taken from the supply, let out.
  static constexpr int kStatesOfChamber = 4;

  Gas gas;
  GasState environment{101325.0, 293.15};
  GasState supply{101325.0, 293.15};
  int sections = 1;
  /// Of the communication with the mechanism [s]: over a step the gas takes
  /// the rate, the mechanism the effort of its start as constant. 0: none, one
  /// integration.
  double step{};
  std::vector<GasChamber> chambers;
  /// The last chamber, of area 0, is what valves open to in place of `supply`:
  /// an insulated tank that all sections share.
  bool has_tank = false;

  /// Behind the chambers' with a step: work on the mechanism and of the gas.
  static constexpr int kWorks = 2;

  bool is_coupled() const { return step > 0.0; }
  int works_index() const {
    return kStatesOfChamber * static_cast<int>(chambers.size());
  }
  int internal_states() const {
    return works_index() + (is_coupled() ? kWorks : 0);
  }
};

using GasInternals =
    std::array<double, GasCylinderLaw::kMostChambers *
                               GasCylinderLaw::kStatesOfChamber +
                           GasCylinderLaw::kWorks>;
using GasChamberStates =
    std::array<GasChamberState, GasCylinderLaw::kMostChambers>;

double chamber_volume(const GasChamber& chamber, double q);

/// Internal states at the start. @throws Error K009 if a chamber has no volume
/// there.
void start_gas(const GasCylinderLaw& law, const std::string& name,
               const std::string& place, double q, double* internal);

/// @param q, rate  of the line. @return effort [N].
double gas_effort(const GasCylinderLaw& law, double t, double q, double rate,
                  const double* internal, GasInternals& rates,
                  GasChamberStates& states);

/// The same over a communication step: evaluates the gas where it believes the
/// line is. @param gas_effort, gas_q  left in `interface`.
/// @return effort on the mechanism [N].
double coupled_gas_effort(const GasCylinderLaw& law, double t, double rate,
                          const double* internal, GasInternals& rates,
                          GasChamberStates& states, GasInterface& interface);
/// Gas and mechanism tell one another effort and rate, as
/// coupled_gas_effort() left them.
void communicate(GasInterface& interface, double t, double rate);

/// A size that is large for each internal state.
void gas_scales(const GasCylinderLaw& law, const double* internal,
                double* scales);

/// @param law  outlives the result.
ElementProperties properties(const GasCylinderLaw& law);
/// @param law  outlives the result.
std::unique_ptr<ActingElement> place(const LineDefinition& definition,
                                     const GasCylinderLaw& law,
                                     const ReferenceFrame& frame);

}  // namespace clevis::mechanism
