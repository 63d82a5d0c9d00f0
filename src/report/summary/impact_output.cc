#include "report/summary/impact_output.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "report/text/csv_field.h"
#include "report/text/text_table.h"

namespace clevis::report {
namespace {

using mechanism::Impact;
using nlohmann::ordered_json;

constexpr double kMillisecond = 1e-3;

ordered_json mass_json(double mass) {
  return std::isfinite(mass) ? ordered_json(mass) : ordered_json();
}

std::string finite_field(double value) {
  return std::isfinite(value) ? fmt::format("{:.12g}", value) : "";
}

/// Force over the largest of all, below which a touch is not shown: rounding of
/// one that grazes [1].
constexpr double kNothing = 1e-9;

/// Indices of those with the largest force, in the order of time.
std::vector<std::size_t> hardest(const std::vector<NamedImpact>& impacts,
                                 std::size_t most) {
  std::vector<std::size_t> order(impacts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    return impacts[a].impact.peak_force > impacts[b].impact.peak_force;
  });
  const auto is_nothing = [&](std::size_t i) {
    return impacts[i].impact.peak_force <=
           kNothing * impacts[order.front()].impact.peak_force;
  };
  while (is_nothing(order.back()) && order.size() > 1) order.pop_back();
  order.resize(std::min(most, order.size()));
  std::ranges::sort(order);
  return order;
}

std::string mass_cell(const NamedImpact& named) {
  return std::isfinite(named.impact.mass)
             ? fmt::format("{:.4g} {}", named.impact.mass,
                           named.angular ? "kg m2" : "kg")
             : "-";
}

}  // namespace

std::vector<NamedImpact> named_impacts(
    const mechanism::MechanismDefinition& definition,
    const mechanism::Motion& motion) {
  std::vector<NamedImpact> found;
  for (const Impact& impact : motion.impacts) {
    const auto& element =
        definition.elements[static_cast<std::size_t>(impact.element)];
    NamedImpact named{.force = name_of(element), .impact = impact};
    if (mechanism::line_of(element) != nullptr) {
      named.end = impact.end == 0 ? "lower" : "upper";
      named.angular = mechanism::is_angle(element, definition.joints);
    }
    found.push_back(std::move(named));
  }
  return found;
}

std::string impacts_text(const std::vector<NamedImpact>& impacts,
                         Colour colour) {
  if (impacts.empty()) return {};
  constexpr std::size_t kShown = 10;
  TextTable table({{"impact"},
                   {"at s", Align::kRight},
                   {"speed", Align::kRight},
                   {"mass", Align::kRight},
                   {"pushed by", Align::kRight},
                   {"for ms", Align::kRight},
                   {"peak", Align::kRight},
                   {"after ms", Align::kRight},
                   {"impulse", Align::kRight},
                   {"leaves with", Align::kRight}});
  const std::vector<std::size_t> shown = hardest(impacts, kShown);
  for (const std::size_t i : shown) {
    const NamedImpact& named = impacts[i];
    const Impact& impact = named.impact;
    const char* speed = named.angular ? "rad/s" : "m/s";
    const char* effort = named.angular ? "N m" : "N";
    table.add_row(
        {{named.end.empty() ? named.force : named.force + ", " + named.end},
         {fmt::format("{:.6g}", impact.t)},
         {fmt::format("{:.5g} {}", impact.approach_speed, speed)},
         {mass_cell(named)},
         {fmt::format("{:.4g} {}", impact.force, effort)},
         {impact.duration
              ? fmt::format("{:.4g}", *impact.duration / kMillisecond)
              : "stays"},
         {fmt::format("{:.5g} {}", impact.peak_force, effort)},
         {fmt::format("{:.4g}", (impact.peak_at - impact.t) / kMillisecond)},
         {fmt::format("{:.4g} {} s", impact.impulse, effort)},
         {impact.duration ? fmt::format("{:.4g} {}", impact.exit_speed, speed)
                          : "-"}});
  }
  std::string text = table.text(colour);
  if (impacts.size() > shown.size()) {
    text += fmt::format("  the {} hardest of {} impacts (all in impacts.csv)\n",
                        shown.size(), impacts.size());
  }
  return text;
}

ordered_json impacts_json(const std::vector<NamedImpact>& impacts) {
  ordered_json list = ordered_json::array();
  for (const NamedImpact& named : impacts) {
    const Impact& i = named.impact;
    const std::string rate = named.angular ? "_rad_per_s" : "_m_per_s";
    const std::string mass = named.angular ? "_kg_m2" : "_kg";
    const std::string effort = named.angular ? "_N_m" : "_N";
    ordered_json json = {{"force", named.force}};
    if (!named.end.empty()) json["end"] = named.end;
    json["at_s"] = i.t;
    json["approach_speed" + rate] = i.approach_speed;
    json["mass_a" + mass] = mass_json(i.mass_a);
    json["mass_b" + mass] = mass_json(i.mass_b);
    json["mass" + mass] = mass_json(i.mass);
    json["pushing" + effort] = i.force;
    json["duration_s"] =
        i.duration ? ordered_json(*i.duration) : ordered_json();
    json["peak" + effort] = i.peak_force;
    json["peak_at_s"] = i.peak_at;
    json["impulse" + effort + "_s"] = i.impulse;
    json["exit_speed" + rate] =
        i.duration ? ordered_json(i.exit_speed) : ordered_json();
    list.push_back(json);
  }
  return list;
}

std::string impacts_csv(const std::vector<NamedImpact>& impacts) {
  std::string text =
      "force,end,at_s,approach_speed,mass_a,mass_b,mass,pushing,duration_s,"
      "peak,peak_at_s,impulse,exit_speed,speed_unit,mass_unit,effort_unit,"
      "impulse_unit\n";
  for (const NamedImpact& named : impacts) {
    const Impact& i = named.impact;
    text += fmt::format(
        "{},{},{:.15g},{:.12g},{},{},{},{:.12g},{},{:.12g},{:.15g},{:.12g},{},"
        "{}\n",
        csv_field(named.force), named.end, i.t, i.approach_speed,
        finite_field(i.mass_a), finite_field(i.mass_b), finite_field(i.mass),
        i.force, i.duration ? finite_field(*i.duration) : "", i.peak_force,
        i.peak_at, i.impulse, i.duration ? finite_field(i.exit_speed) : "",
        named.angular ? "rad/s,kg m2,N m,N m s" : "m/s,kg,N,N s");
  }
  return text;
}

}  // namespace clevis::report
