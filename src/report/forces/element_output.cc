#include "report/forces/element_output.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include <fmt/compile.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "mechanism/force_elements/force_element.h"
#include "report/forces/gas_output.h"
#include "report/forces/motor_output.h"
#include "report/summary/impact_output.h"
#include "report/summary/mechanism_summary.h"
#include "report/text/csv_field.h"
#include "report/text/text_table.h"
#include "report/text/units.h"

namespace clevis::report {
namespace {

using mechanism::ElementState;
using mechanism::ForceElement;
using nlohmann::ordered_json;

constexpr double kDegree = std::numbers::pi / 180.0;

bool turns(const MotionReport& report, const ForceElement& element) {
  return mechanism::is_angle(element, report.definition.joints);
}

/// Key of a channel with the unit of its line's coordinate.
std::string key_of(const mechanism::ElementChannel& channel, const char* unit) {
  return channel.is_coordinate ? channel.key + unit : channel.key;
}

/// Coordinate of an element's line as JSON gives it: degrees or millimetres.
double shown_coordinate(double value, bool angle) {
  return angle ? value / kDegree : millimetres(value);
}

Peak peak_effort(const MotionReport& report, std::size_t k) {
  Peak peak;
  for (const auto& instant : report.motion.instants) {
    const double here = std::abs(instant.elements[k].effort);
    if (here > peak.value) peak = {here, instant.t};
  }
  return peak;
}

const std::string& source(const MotionReport& report,
                          const mechanism::MotionEvent& event) {
  return name_of(
      report.definition.elements[static_cast<std::size_t>(event.element)]);
}

bool is_unique(const MotionReport& report, std::size_t k) {
  return std::ranges::all_of(report.motion.instants, [k](const auto& instant) {
    return instant.elements[k].unique;
  });
}

void add_open_friction(TextTable& table, const MotionReport& report) {
  for (std::size_t k = 0; k < report.definition.elements.size(); ++k) {
    if (is_unique(report, k)) continue;
    table.add_note(fmt::format(
        "{}: not unique at rest, where other friction holds the same motion",
        name_of(report.definition.elements[k])));
  }
}

void add_events(std::string& text, const MotionReport& report) {
  constexpr std::size_t kShown = 10;
  const auto& events = report.motion.events;
  if (events.empty()) return;
  text += fmt::format("{} events", events.size());
  const std::size_t shown = std::min(kShown, events.size());
  if (shown < events.size()) {
    text += fmt::format(", the first {} (all in events.csv)", shown);
  }
  text += ":\n";
  for (std::size_t i = 0; i < shown; ++i) {
    text += fmt::format("  {:.9f} s  {} {}\n", events[i].t,
                        source(report, events[i]), events[i].what);
  }
}

/// How forces.csv shows an element.
struct ElementColumns {
  std::vector<mechanism::ElementChannel> channels;
  bool angle{};
  /// Of coordinates: radians, millimetres.
  double scale() const { return angle ? 1.0 : 1e3; }
};

/// Titles of an element's columns, each behind a comma.
void add_titles(std::string& text, const ForceElement& element,
                const ElementColumns& columns) {
  const bool angle = columns.angle;
  const std::string& name = name_of(element);
  for (const std::string& title :
       {name + (angle ? ".position_rad" : ".position_mm"),
        name + (angle ? ".rate_rad_per_s" : ".rate_m_per_s"),
        name + (angle ? ".effort_N_m" : ".effort_N"), name + ".friction_N",
        name + ".power_W"}) {
    text += ',';
    text += csv_field(title);
  }
  add_chamber_titles(text, element);
  add_interface_titles(text, element);
  add_motor_titles(text, element);
  for (const auto& channel : columns.channels) {
    text += ',';
    text += csv_field(name + '.' + key_of(channel, angle ? "_rad" : "_mm"));
  }
}

/// Values of an element's columns, each behind a comma.
void add_values(std::string& text, const ElementState& state,
                const ElementColumns& columns) {
  const auto add = [&text](double value) {
    fmt::format_to(std::back_inserter(text), FMT_COMPILE(",{:.12g}"),
                   value + 0.0);
  };
  add(columns.scale() * state.position);
  for (const double value :
       {state.rate, state.effort, state.friction, state.power}) {
    add(value);
  }
  for (const auto& chamber : state.chambers) {
    for (const double value : chamber_values(chamber)) add(value);
  }
  if (state.interface) {
    for (const double value : interface_values(*state.interface)) add(value);
  }
  if (state.motor) {
    for (const double value : motor_values(*state.motor)) add(value);
  }
  for (std::size_t c = 0; c < state.channels.size(); ++c) {
    const double scale =
        columns.channels[c].is_coordinate ? columns.scale() : 1.0;
    add(scale * state.channels[c]);
  }
}

}  // namespace

std::string forces_csv(const MotionReport& report) {
  std::string text = "t_s";
  std::vector<ElementColumns> columns;
  for (const ForceElement& element : report.definition.elements) {
    columns.push_back({properties(element).channels, turns(report, element)});
    add_titles(text, element, columns.back());
  }
  text += "\n";
  for (const auto& instant : report.motion.instants) {
    fmt::format_to(std::back_inserter(text), "{:.12g}", instant.t);
    for (std::size_t k = 0; k < instant.elements.size(); ++k) {
      add_values(text, instant.elements[k], columns[k]);
    }
    text += "\n";
  }
  return text;
}

std::string events_csv(const MotionReport& report) {
  std::string text = "t_s,force,event\n";
  for (const auto& event : report.motion.events) {
    text += fmt::format("{:.15g},{},{}\n", event.t,
                        csv_field(source(report, event)), event.what);
  }
  return text;
}

ordered_json forces_json(const MotionReport& report) {
  ordered_json forces = ordered_json::array();
  const auto& motion = report.motion;
  for (std::size_t k = 0; k < report.definition.elements.size(); ++k) {
    const ForceElement& element = report.definition.elements[k];
    const mechanism::ElementProperties given = properties(element);
    const bool angle = turns(report, element);
    const Peak peak = peak_effort(report, k);
    ordered_json shown = ordered_json::array();
    for (const std::size_t i : shown_instants(motion)) {
      const ElementState& state = motion.instants[i].elements[k];
      shown.push_back({{"t_s", motion.instants[i].t},
                       {angle ? "position_deg" : "position_mm",
                        shown_coordinate(state.position, angle)},
                       {angle ? "effort_N_m" : "effort_N", state.effort}});
      if (given.slides) shown.back()["friction_N"] = state.friction;
      if (!state.chambers.empty()) {
        shown.back()["chambers"] = chambers_json(element, state);
      }
      if (state.motor) shown.back()["motor"] = motor_json(*state.motor);
      for (std::size_t c = 0; c < state.channels.size(); ++c) {
        const auto& channel = given.channels[c];
        shown.back()[key_of(channel, angle ? "_deg" : "_mm")] =
            channel.is_coordinate ? shown_coordinate(state.channels[c], angle)
                                  : state.channels[c];
      }
    }
    forces.push_back({{"name", name_of(element)},
                      {"type", given.type},
                      {angle ? "peak_effort_N_m" : "peak_effort_N", peak.value},
                      {"peak_effort_at_s", peak.at},
                      {"unique", is_unique(report, k)},
                      {"instants", shown}});
    if (given.gas != nullptr) {
      forces.back()["chambers"] = gas_summary_json(motion, k, element);
      if (given.gas->is_coupled()) {
        forces.back()["interface"] = interface_summary_json(motion, k, element);
      }
    }
    if (given.is_motor) {
      forces.back()["motor"] = motor_summary_json(motion, k);
    }
  }
  return forces;
}

ordered_json events_json(const MotionReport& report) {
  ordered_json events = ordered_json::array();
  for (const auto& event : report.motion.events) {
    events.push_back({{"t_s", event.t},
                      {"force", source(report, event)},
                      {"event", event.what}});
  }
  return events;
}

std::string forces_text(const MotionReport& report, Colour colour) {
  if (report.definition.elements.empty()) return {};
  std::vector<TextTable::Column> columns{{"force"}, {"type"}};
  const std::vector<std::size_t> instants = shown_instants(report.motion);
  for (const std::size_t i : instants) {
    columns.push_back({fmt::format("at {:.6g} s", report.motion.instants[i].t),
                       Align::kRight});
  }
  columns.push_back({"peak", Align::kRight});
  columns.push_back({"at s", Align::kRight});
  TextTable table(columns);
  for (std::size_t k = 0; k < report.definition.elements.size(); ++k) {
    const ForceElement& element = report.definition.elements[k];
    const char* unit = turns(report, element) ? " N m" : " N";
    std::vector<TextTable::Cell> cells{{name_of(element)},
                                       {std::string(properties(element).type)}};
    for (const std::size_t i : instants) {
      const double effort = report.motion.instants[i].elements[k].effort;
      cells.push_back({fmt::format("{:.4g}{}", effort + 0.0, unit)});
    }
    const Peak peak = peak_effort(report, k);
    cells.push_back({fmt::format("{:.4g}{}", peak.value, unit)});
    cells.push_back({fmt::format("{:.6g}", peak.at)});
    table.add_row(cells);
  }
  add_open_friction(table, report);
  std::string text = table.text(colour);
  text += gas_text(report, colour);
  text += motors_text(report, colour);
  const std::string impacts =
      impacts_text(named_impacts(report.definition, report.motion), colour);
  if (!impacts.empty()) text += "\n" + impacts + "\n";
  add_events(text, report);
  return text;
}

}  // namespace clevis::report
