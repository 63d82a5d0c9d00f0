#include "scene/line_elements/read_gas_cylinder.h"

#include <array>
#include <numbers>
#include <set>
#include <string>

#include <fmt/format.h>

#include "scene/text/times.h"

namespace clevis::scene {
namespace {

using namespace mechanism;

Gas read_gas(StrictTable table) {
  Gas gas;
  gas.gas_constant = table["gas_constant"].positive(Dimension::kSpecificHeat);
  const Value heat = table["specific_heat"];
  gas.specific_heat = heat.positive(Dimension::kSpecificHeat);
  if (gas.specific_heat <= gas.gas_constant) {
    throw heat.refusal("S006", "is not above the gas constant",
                       "Give the specific heat at constant pressure.");
  }
  return gas;
}

/// `pressure`, absolute, or `gauge_pressure`, above the environment's.
double read_pressure(StrictTable& table, const GasState& environment,
                     double otherwise) {
  if (const auto gauge = table.find("gauge_pressure")) {
    const double p = environment.pressure + gauge->quantity(Dimension::kStress);
    if (!(p > 0.0)) {
      throw gauge->refusal("S006", "is below vacuum",
                           "Give a pressure above the environment's, or a "
                           "little below it.");
    }
    return p;
  }
  const auto pressure = table.find("pressure");
  return pressure ? pressure->positive(Dimension::kStress) : otherwise;
}

double read_temperature(StrictTable& table, double otherwise) {
  const auto temperature = table.find("temperature");
  return temperature ? temperature->positive(Dimension::kTemperature)
                     : otherwise;
}

GasState read_supply(StrictTable& table, const GasState& environment) {
  GasState supply;
  supply.temperature = read_temperature(table, environment.temperature);
  if (!table.has("pressure") && !table.has("gauge_pressure")) {
    throw table.refusal("S003",
                        "lacks the key \"pressure\" or \"gauge_pressure\"",
                        "Give one of them.");
  }
  supply.pressure = read_pressure(table, environment, 0.0);
  if (supply.pressure <= environment.pressure) {
    throw table.refusal("S006", "has no pressure above the environment's",
                        "Pressure is absolute, gauge_pressure above the "
                        "environment's.");
  }
  return supply;
}

double read_piston_area(StrictTable& table) {
  if (table.has("area")) return table["area"].positive(Dimension::kArea);
  if (!table.has("bore")) {
    throw table.refusal("S003", "lacks the key \"bore\" or \"area\"",
                        "Give one of them.");
  }
  const double bore = table["bore"].positive(Dimension::kLength);
  double rod = 0.0;
  if (const auto given = table.find("rod")) {
    rod = given->positive(Dimension::kLength);
    if (rod >= bore) {
      throw given->refusal("S006", "is not below the bore",
                           "The rod stands inside the bore.");
    }
  }
  return 0.25 * std::numbers::pi * (bore * bore - rod * rod);
}

/// Sonic conductance by whichever of the four keys is given.
double read_conductance(StrictTable& table, double critical_ratio,
                        const Gas& gas) {
  // a key of the others is then unread, and refused
  if (table.has("sonic_conductance")) {
    return table["sonic_conductance"].positive(Dimension::kSonicConductance);
  }
  if (table.has("kv")) {
    constexpr double kHour = 3600.0;
    return conductance_of_kv(
        kHour * table["kv"].positive(Dimension::kVolumeFlow), critical_ratio);
  }
  if (table.has("cv")) {
    return conductance_of_cv(table["cv"].number(1e-9, 1e6), critical_ratio);
  }
  if (!table.has("area")) {
    throw table.refusal(
        "S003",
        "lacks the key \"kv\", \"cv\", \"sonic_conductance\" or \"area\"",
        "Give one of them.");
  }
  const double area = table["area"].positive(Dimension::kArea);
  return conductance_of_area(
      area, table["discharge_coefficient"].number(1e-3, 1.0), gas);
}

void read_opening(StrictTable& table, GasValve& valve) {
  if (table.has("openings")) {
    const Value openings = table["openings"];
    valve.times = increasing_times(table["times"], 1);
    for (const Value& opening : openings.elements()) {
      valve.signals.push_back(opening.number(-1.0, 1.0));
    }
    if (valve.times.size() != valve.signals.size()) {
      throw openings.refusal(
          "S010",
          fmt::format("has {} entries for {} times", valve.signals.size(),
                      valve.times.size()),
          "Give one opening for each time.");
    }
    return;
  }
  const double opening = table["opening"].number(-1.0, 1.0);
  valve.times = {0.0};
  valve.signals = {opening};
  if (const auto time = table.find("opening_time")) {
    const auto start = table.find("opening_start");
    valve.times[0] = start ? start->quantity(Dimension::kTime) : 0.0;
    valve.times.push_back(valve.times[0] + time->positive(Dimension::kTime));
    valve.signals = {0.0, opening};
  }
}

GasValve read_valve(StrictTable table, const Gas& gas) {
  GasValve valve;
  const auto ratio = [&table](const char* key, double least, double most,
                              double otherwise) {
    const auto value = table.find(key);
    return value ? value->number(least, most) : otherwise;
  };
  Orifice& orifice = valve.orifice;
  orifice.critical_ratio = ratio("critical_ratio", 0.0, 0.9, 0.3);
  orifice.laminar_ratio = ratio("laminar_ratio", 0.95, 0.999999, 0.999);
  orifice.conductance = read_conductance(table, orifice.critical_ratio, gas);
  valve.leakage = ratio("leakage", 0.0, 0.1, 1e-6);
  valve.smoothing = ratio("smoothing", 0.0, 0.4, 0.01);
  read_opening(table, valve);
  table.finish("beside another key for its size or its opening");
  return valve;
}

GasChamber read_chamber(StrictTable& table, const GasCylinderLaw& law,
                        std::size_t number) {
  GasChamber chamber;
  const auto name = table.find("name");
  chamber.name = name ? name->name() : fmt::format("chamber_{}", number);
  if (const auto pushes = table.find("pushes")) {
    chamber.sense =
        pushes->choice<double>({{"apart", 1.0}, {"together", -1.0}});
  }
  chamber.area = read_piston_area(table);
  chamber.dead_volume = table["dead_volume"].positive(Dimension::kVolume);
  chamber.origin = table["origin"].quantity(Dimension::kLength);
  chamber.start.pressure =
      read_pressure(table, law.environment, law.environment.pressure);
  chamber.start.temperature =
      read_temperature(table, law.environment.temperature);
  if (const auto heat = table.find("heat")) {
    chamber.heat =
        heat->choice<ChamberHeat>({{"insulated", ChamberHeat::kInsulated},
                                   {"conducting", ChamberHeat::kConducting},
                                   {"isothermal", ChamberHeat::kIsothermal}});
  }
  if (chamber.heat == ChamberHeat::kConducting) {
    chamber.wall_conductance =
        table["wall_conductance"].positive(Dimension::kThermalConductance);
  }
  if (table.has("valve")) {
    chamber.valve = read_valve(table.table("valve"), law.gas);
  }
  table.finish("beside area, gauge_pressure or without heat = \"conducting\"");
  return chamber;
}

void refuse_equal_names(const StrictTable& table, const GasCylinderLaw& law) {
  std::set<std::string> names;
  for (const GasChamber& chamber : law.chambers) {
    if (names.insert(chamber.name).second) continue;
    throw table.refusal("S008",
                        "has two chambers of one name (\"supply\" is the "
                        "tank's)",
                        "Name them apart.");
  }
}

/// `coupling`: "monolithic" (0), or the step of the communication.
double read_step(StrictTable& table) {
  const auto coupling = table.find("coupling");
  if (!coupling) return 0.0;
  if (coupling->is_table()) {
    return table.table("coupling")["step"].positive(Dimension::kTime);
  }
  return coupling->choice<double>({{"monolithic", 0.0}});
}

}  // namespace

mechanism::LineLaw read_gas_cylinder(const LineSource& source) {
  StrictTable& table = source.table;
  if (source.is_angle()) {
    throw table.refusal("S010", "acts on an angle",
                        "A gas cylinder needs a joint that slides, or points.");
  }
  GasCylinderLaw law;
  if (const auto sections = table.find("sections")) {
    law.sections = sections->integer(1, 100);
  }
  law.step = read_step(table);
  if (table.has("gas")) law.gas = read_gas(table.table("gas"));
  if (table.has("environment")) {
    StrictTable environment = table.table("environment");
    law.environment.pressure =
        environment["pressure"].positive(Dimension::kStress);
    law.environment.temperature =
        read_temperature(environment, law.environment.temperature);
  }
  const auto chambers = table.tables("chamber");
  if (chambers.empty() ||
      chambers.size() >= static_cast<std::size_t>(law.kMostChambers)) {
    throw table.refusal("S003", "has not one to seven [[force.chamber]]",
                        "Give a chamber for each side of a piston that "
                        "holds gas; cylinders elsewhere are more forces.");
  }
  GasChamber tank;
  if (table.has("supply")) {
    StrictTable supply = table.table("supply");
    law.supply = read_supply(supply, law.environment);
    if (const auto volume = supply.find("volume")) {
      law.has_tank = true;
      tank.dead_volume = volume->positive(Dimension::kVolume);
    }
    supply.finish("with gauge_pressure");
  }
  for (StrictTable chamber : chambers) {
    law.chambers.push_back(read_chamber(chamber, law, law.chambers.size() + 1));
    if (law.chambers.back().valve && !table.has("supply")) {
      throw table.refusal("S003", "lacks the key \"supply\"",
                          "Give the pressure that its valve opens to.");
    }
  }
  if (law.has_tank) {
    tank.name = "supply";
    tank.start = law.supply;
    law.chambers.push_back(tank);
  }
  refuse_equal_names(table, law);
  return law;
}

}  // namespace clevis::scene
