#include "report/forces/coupling_output.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "mechanism/definition/pitch_radii.h"
#include "mechanism/joints/joint_types.h"
#include "report/summary/mechanism_summary.h"
#include "report/text/text_table.h"

namespace clevis::report {
namespace {

using nlohmann::ordered_json;

bool turns(const MotionReport& report, std::size_t k) {
  const auto& coupling = report.definition.couplings[k];
  const auto joint = static_cast<std::size_t>(coupling.joint_1);
  return coordinate_row(report.definition.joints[joint].type,
                        coupling.coordinate_1)
      .is_angle();
}

template <class Size>
Peak peak_of(const MotionReport& report, std::size_t k, const Size& size) {
  Peak peak;
  for (const auto& instant : report.motion.instants) {
    const double here = size(instant.couplings[k]);
    if (here > peak.value) peak = {here, instant.t};
  }
  return peak;
}

Peak peak_effort(const MotionReport& report, std::size_t k) {
  return peak_of(report, k, [](const mechanism::CouplingState& coupling) {
    return std::abs(coupling.effort);
  });
}

/// Largest tooth force; nothing where it is not resolved.
std::optional<Peak> peak_tooth_force(const MotionReport& report,
                                     std::size_t k) {
  if (!std::ranges::all_of(report.motion.instants, [k](const auto& instant) {
        return instant.couplings[k].teeth.has_value();
      })) {
    return std::nullopt;
  }
  return peak_of(report, k, [](const mechanism::CouplingState& coupling) {
    return coupling.teeth->f_W.norm();
  });
}

std::vector<double> radii_mm(const MotionReport& report, std::size_t k) {
  auto radii = mechanism::pitch_radii(report.definition.joints,
                                      report.definition.couplings[k]);
  for (double& radius : radii) radius *= 1e3;
  return radii;
}

bool is_unique(const MotionReport& report, std::size_t k) {
  return std::ranges::all_of(report.motion.instants, [k](const auto& instant) {
    return instant.couplings[k].unique;
  });
}

}  // namespace

ordered_json couplings_json(const MotionReport& report) {
  ordered_json couplings = ordered_json::array();
  for (std::size_t k = 0; k < report.definition.couplings.size(); ++k) {
    const bool angle = turns(report, k);
    const Peak peak = peak_effort(report, k);
    ordered_json shown = ordered_json::array();
    for (const std::size_t i : shown_instants(report.motion)) {
      const auto& instant = report.motion.instants[i];
      shown.push_back({{"t_s", instant.t},
                       {angle ? "effort_N_m" : "effort_N",
                        instant.couplings[k].effort + 0.0}});
    }
    ordered_json coupling{
        {"name", report.definition.couplings[k].name},
        {angle ? "peak_effort_N_m" : "peak_effort_N", peak.value},
        {"peak_effort_at_s", peak.at},
        {"unique", is_unique(report, k)}};
    if (const auto force = peak_tooth_force(report, k)) {
      coupling["pitch_radii_mm"] = radii_mm(report, k);
      coupling["peak_tooth_force_N"] = force->value;
      coupling["peak_tooth_force_at_s"] = force->at;
    }
    coupling["instants"] = shown;
    couplings.push_back(std::move(coupling));
  }
  return couplings;
}

std::string couplings_text(const MotionReport& report, Colour colour) {
  if (report.definition.couplings.empty()) return {};
  std::vector<TextTable::Column> columns{{"coupling"}};
  const std::vector<std::size_t> shown = shown_instants(report.motion);
  for (const std::size_t i : shown) {
    columns.push_back({fmt::format("at {:.6g} s", report.motion.instants[i].t),
                       Align::kRight});
  }
  columns.push_back({"peak", Align::kRight});
  columns.push_back({"at s", Align::kRight});
  columns.push_back({"unique"});
  const bool has_teeth = std::ranges::any_of(
      report.definition.couplings, [](const auto& coupling) {
        return coupling.teeth.has_value();
      });
  if (has_teeth) {
    columns.push_back({"pitch radii"});
    columns.push_back({"largest tooth force", Align::kRight});
  }
  TextTable table(columns);
  for (std::size_t k = 0; k < report.definition.couplings.size(); ++k) {
    const char* unit = turns(report, k) ? " N m" : " N";
    std::vector<TextTable::Cell> cells{{report.definition.couplings[k].name}};
    for (const std::size_t i : shown) {
      const double effort = report.motion.instants[i].couplings[k].effort;
      cells.push_back({fmt::format("{:.4g}{}", effort + 0.0, unit)});
    }
    const Peak peak = peak_effort(report, k);
    cells.push_back({fmt::format("{:.4g}{}", peak.value, unit)});
    cells.push_back({fmt::format("{:.6g}", peak.at)});
    cells.push_back({is_unique(report, k) ? "yes" : "no"});
    if (const auto force = peak_tooth_force(report, k)) {
      cells.push_back(
          {fmt::format("{:.4g} mm", fmt::join(radii_mm(report, k), ", "))});
      cells.push_back({fmt::format("{:.4g} N", force->value)});
    } else if (has_teeth) {
      cells.insert(cells.end(), 2, {"-"});
    }
    table.add_row(cells);
  }
  return table.text(colour);
}

}  // namespace clevis::report
