#include "report/forces/gas_output.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "report/text/csv_field.h"
#include "report/text/text_table.h"

namespace clevis::report {
namespace {

using mechanism::ForceElement;
using mechanism::GasChamberState;
using mechanism::GasCylinderLaw;
using mechanism::Motion;
using nlohmann::ordered_json;

constexpr double kMega = 1e6;

constexpr std::array<const char*, 8> kTitles{
    "volume_cm3",      "pressure_MPa",     "temperature_K", "mass_kg",
    "inflow_kg_per_s", "outflow_kg_per_s", "taken_kg",      "released_kg"};

struct Summary {
  double least_pressure{}, largest_pressure{};        ///< [Pa]
  double least_temperature{}, largest_temperature{};  ///< [K]
  double taken{}, released{};                         ///< [kg]
  double balance_error{};  ///< of the mass, over its largest [1]
};

Summary summary(const Motion& motion, std::size_t element, std::size_t k) {
  const auto at = [&](const mechanism::Instant& instant) -> const auto& {
    return instant.elements[element].chambers[k];
  };
  const GasChamberState& first = at(motion.instants.front());
  Summary result{first.pressure,
                 first.pressure,
                 first.temperature,
                 first.temperature,
                 at(motion.instants.back()).taken,
                 at(motion.instants.back()).released};
  double largest = 0.0;
  for (const auto& instant : motion.instants) {
    const GasChamberState& c = at(instant);
    result.least_pressure = std::min(result.least_pressure, c.pressure);
    result.largest_pressure = std::max(result.largest_pressure, c.pressure);
    result.least_temperature =
        std::min(result.least_temperature, c.temperature);
    result.largest_temperature =
        std::max(result.largest_temperature, c.temperature);
    const double gap = c.mass - first.mass - c.taken + c.released;
    result.balance_error = std::max(result.balance_error, std::abs(gap));
    largest = std::max(largest, c.mass);
  }
  result.balance_error /= largest;
  return result;
}

}  // namespace

void add_chamber_titles(std::string& text, const ForceElement& element) {
  const GasCylinderLaw* law = properties(element).gas;
  if (law == nullptr) return;
  for (const auto& chamber : law->chambers) {
    for (const char* title : kTitles) {
      text += ',';
      text += csv_field(
          fmt::format("{}.{}.{}", name_of(element), chamber.name, title));
    }
  }
}

std::array<double, 8> chamber_values(const GasChamberState& c) {
  return {1e6 * c.volume, c.pressure / kMega, c.temperature, c.mass,
          c.inflow,       c.outflow,          c.taken,       c.released};
}

void add_interface_titles(std::string& text, const ForceElement& element) {
  const GasCylinderLaw* law = properties(element).gas;
  if (law == nullptr || !law->is_coupled()) return;
  for (const char* title :
       {"gas_position_mm", "gas_rate_m_per_s", "gas_effort_N",
        "work_on_mechanism_J", "work_of_gas_J"}) {
    text += ',';
    text += csv_field(fmt::format("{}.{}", name_of(element), title));
  }
}

std::array<double, 5> interface_values(
    const mechanism::GasInterface& interface) {
  return {1e3 * interface.gas_q, interface.rate, interface.gas_effort,
          interface.work_on_mechanism, interface.work_of_gas};
}

ordered_json interface_summary_json(const Motion& motion, std::size_t element,
                                    const ForceElement& force) {
  double lag = 0.0;
  for (const auto& instant : motion.instants) {
    const auto& state = instant.elements[element];
    lag = std::max(lag, std::abs(state.interface->gas_q - state.position));
  }
  const auto& last = *motion.instants.back().elements[element].interface;
  return {{"step_s", properties(force).gas->step},
          {"largest_position_gap_mm", 1e3 * lag},
          {"work_on_mechanism_J", last.work_on_mechanism},
          {"work_of_gas_J", last.work_of_gas},
          {"energy_drift_J", last.work_on_mechanism - last.work_of_gas}};
}

ordered_json chambers_json(const ForceElement& element,
                           const mechanism::ElementState& state) {
  ordered_json chambers = ordered_json::array();
  for (std::size_t k = 0; k < state.chambers.size(); ++k) {
    ordered_json chamber{{"name", properties(element).gas->chambers[k].name}};
    const auto values = chamber_values(state.chambers[k]);
    for (std::size_t i = 0; i < values.size(); ++i) {
      chamber[kTitles[i]] = values[i];
    }
    chambers.push_back(std::move(chamber));
  }
  return chambers;
}

ordered_json gas_summary_json(const Motion& motion, std::size_t element,
                              const ForceElement& force) {
  ordered_json chambers = ordered_json::array();
  const GasCylinderLaw& law = *properties(force).gas;
  for (std::size_t k = 0; k < law.chambers.size(); ++k) {
    const Summary s = summary(motion, element, k);
    chambers.push_back({{"name", law.chambers[k].name},
                        {"sections", law.sections},
                        {"least_pressure_MPa", s.least_pressure / kMega},
                        {"largest_pressure_MPa", s.largest_pressure / kMega},
                        {"least_temperature_K", s.least_temperature},
                        {"largest_temperature_K", s.largest_temperature},
                        {"taken_kg", s.taken},
                        {"released_kg", s.released},
                        {"mass_balance_error", s.balance_error}});
  }
  return chambers;
}

std::string gas_text(const MotionReport& report, Colour colour) {
  TextTable table({{"chamber"},
                   {"pressure MPa (absolute)", Align::kRight},
                   {"temperature K", Align::kRight},
                   {"taken g", Align::kRight},
                   {"released g", Align::kRight},
                   {"mass balance", Align::kRight}});
  bool any = false;
  const auto& elements = report.definition.elements;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const GasCylinderLaw* law = properties(elements[e]).gas;
    for (std::size_t k = 0; law != nullptr && k < law->chambers.size(); ++k) {
      const Summary s = summary(report.motion, e, k);
      any = true;
      table.add_row(
          {{fmt::format("{}.{}{}", name_of(elements[e]), law->chambers[k].name,
                        law->sections > 1
                            ? fmt::format(" (1 of {})", law->sections)
                            : std::string())},
           {fmt::format("{:.5g} to {:.5g}", s.least_pressure / kMega,
                        s.largest_pressure / kMega)},
           {fmt::format("{:.5g} to {:.5g}", s.least_temperature,
                        s.largest_temperature)},
           {fmt::format("{:.5g}", 1e3 * s.taken)},
           {fmt::format("{:.5g}", 1e3 * s.released)},
           {fmt::format("{:.1e}", s.balance_error)}});
    }
  }
  return any ? table.text(colour) : std::string();
}

}  // namespace clevis::report
