#include "report/compare/tolerance.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "base/errors.h"

namespace clevis::report {
namespace {

constexpr Tolerance compare(double relative, double absolute) {
  return {Treatment::kCompare, relative, absolute};
}

constexpr Tolerance note(double absolute) {
  return {Treatment::kNote, 0.0, absolute};
}

// The absolute parts only stand for zero: far below what anybody reads, far
// above round-off.
constexpr auto kRules = std::to_array<ToleranceRule>({
    {"verdict", "", compare(0, 0), "a verdict is a word"},
    {"complete", "", compare(0, 0), "an interrupted check lacks parts"},
    {"mobility", "", compare(0, 0), "a count"},
    {"redundant_constraints", "", compare(0, 0), "a count"},
    {"instants", "", compare(0.05, 0),
     "another sampling is another run, but of the instants that clevis adds at "
     "peaks round-off may choose one or another"},
    {"peak_force", "N", compare(1e-6, 1e-6),
     "reactions solve small dense systems: only round-off (1e-12) may move "
     "them"},
    {"peak_moment", "Nm", compare(1e-6, 1e-6), "as peak_force"},
    {"peak_effort", "N", compare(1e-6, 1e-6), "as peak_force"},
    {"peak_torque", "Nm", compare(1e-6, 1e-6), "as peak_force"},
    {"mass", "kg", compare(1e-6, 0),
     "an integral over the mesh: 0.1 mm of geometry moves it by 1e-5 or more"},
    {"peak_verdict", "", compare(0, 0), "a verdict is a word"},
    {"peak_von_mises", "MPa", compare(2e-3, 1e-6),
     "a fifth of the 1 % that a check aims at, so a change of 0.5 % is caught; "
     "solver and libraries move it by less than 1e-6"},
    {"band_low", "MPa", compare(2e-3, 1e-6), "as peak_von_mises"},
    {"band_high", "MPa", compare(2e-3, 1e-6), "as peak_von_mises"},
    {"safety_factor", "", compare(2e-3, 0), "as peak_von_mises"},
    {"deflection", "mm", compare(2e-3, 1e-9), "as peak_von_mises"},
    {"strain_energy", "mJ", compare(2e-3, 1e-9), "as peak_von_mises"},
    {"section_stress", "MPa", compare(2e-3, 1e-6), "as peak_von_mises"},
    {"section_low", "MPa", compare(2e-3, 1e-6), "as peak_von_mises"},
    {"section_high", "MPa", compare(2e-3, 1e-6), "as peak_von_mises"},
    {"striker_mass", "kg", compare(1e-6, 0), "as peak_force"},
    {"striker_speed", "m/s", compare(1e-6, 1e-9), "as peak_force"},
    {"striker_force", "N", compare(1e-6, 1e-6), "as peak_force"},
    {"first_period", "s", compare(2e-3, 0), "as peak_von_mises"},
    {"contact_force", "N", compare(2e-3, 1e-6), "as peak_von_mises"},
    {"contact_duration", "s", compare(2e-3, 0), "as peak_von_mises"},
    {"contact_rise", "s", compare(1e-2, 0), "a time of a flat top"},
    {"dynamic_factor", "", compare(2e-3, 0), "as peak_von_mises"},
    {"deflection_low", "mm", compare(2e-3, 1e-9), "as peak_von_mises"},
    {"deflection_high", "mm", compare(2e-3, 1e-9), "as peak_von_mises"},
    {"face_deflection", "mm", compare(2e-3, 1e-9), "as peak_von_mises"},
    {"later_stress", "", compare(1e-2, 0),
     "of few shapes, and of a bouncing striker sensitive to all"},
    {"later_deflection", "", compare(1e-2, 0), "as later_stress"},
    {"free_swing_stress", "", compare(1e-2, 0), "as later_stress"},
    {"free_swing_deflection", "", compare(1e-2, 0), "as later_stress"},
    {"settles", "", compare(0, 0), "a verdict is a word"},
    {"vibration_ratio", "", compare(2e-3, 0), "as peak_von_mises"},
    {"beam_stress", "MPa", compare(5e-4, 1e-6),
     "closed forms: only the section cuts through the mesh may move them"},
    {"beam_deflection", "mm", compare(5e-4, 1e-9), "as beam_stress"},
    {"buckling_safety", "", compare(5e-4, 0), "as beam_stress"},
    {"buckling_factor", "", compare(2e-3, 0), "as peak_von_mises"},
    {"probe_stress", "MPa", compare(2e-3, 1e-6), "as peak_von_mises"},
    {"probe_displacement", "mm", compare(2e-3, 1e-9), "as peak_von_mises"},
    {"bearing_load", "N", compare(1e-6, 1e-6), "as peak_force"},
    {"static_load", "N", compare(1e-6, 1e-6), "as peak_force"},
    {"static_safety", "", compare(1e-6, 0), "as peak_force"},
    {"bearing_life", "h", compare(1e-5, 0),
     "goes with the third power of the load, or nearly the fourth"},
    {"ratio", "", compare(1e-9, 0), "closed forms: only round-off"},
    {"compliance", "", compare(1e-9, 0), "as ratio"},
    {"last_stage", "", compare(1e-9, 0), "as ratio"},
    {"frequency", "Hz", compare(1e-9, 0), "as ratio"},
    {"worst_case", "", compare(1e-9, 0), "as ratio"},
    {"root_of_squares", "", compare(1e-9, 0), "as ratio"},
    {"reversal", "", compare(1e-9, 0), "as ratio"},
    {"reversal_run", "", compare(1e-6, 0),
     "a run in small steps: its round-off adds up"},
    {"model", "", note(0),
     "the ladder may take another rung to the same value"},
    {"peak_position", "mm", note(0.05),
     "symmetric parts have equal peaks at several places, and round-off "
     "chooses; where the peak is single, its value moves too"},
    {"peak_instant", "s", note(1e-9), "as peak_position"},
});

/// Reads a number >= 0 off the front of `text`, and the blanks around it.
std::optional<double> take_number(std::string_view& text) {
  double value{};
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value) || std::signbit(value)) {
    return std::nullopt;
  }
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  return value;
}

std::string known_quantities() {
  std::string list;
  for (const ToleranceRule& rule : kRules) {
    list += (list.empty() ? "" : ", ") + std::string(rule.quantity);
  }
  return list;
}

const ToleranceRule* find_rule(std::string_view quantity) {
  const auto found =
      std::ranges::find(kRules, quantity, &ToleranceRule::quantity);
  return found != kRules.end() ? &*found : nullptr;
}

}  // namespace

std::span<const ToleranceRule> tolerance_rules() {
  return kRules;
}

const ToleranceRule& rule_of(std::string_view quantity) {
  const ToleranceRule* rule = find_rule(quantity);
  assert(rule != nullptr && "quantity without a rule");
  return *rule;
}

std::optional<Tolerance> parse_tolerance(std::string_view text,
                                         std::string_view unit) {
  if (text == "off") return Tolerance{Treatment::kIgnore, 0, 0};
  if (text == "note") return Tolerance{Treatment::kNote, 0, 0};
  Tolerance tolerance = compare(0, 0);
  for (;;) {
    const std::size_t plus = text.find(" + ");
    std::string_view term = text.substr(0, plus);
    const std::optional<double> value = take_number(term);
    if (!value) return std::nullopt;
    if (term == "%") {
      tolerance.relative += *value / 100.0;
    } else if (!unit.empty() && term == unit) {
      tolerance.absolute += *value;
    } else {
      return std::nullopt;
    }
    if (plus == std::string_view::npos) return tolerance;
    text.remove_prefix(plus + 3);
  }
}

std::string text(const Tolerance& tolerance, std::string_view unit) {
  if (tolerance.treatment == Treatment::kIgnore) return "off";
  if (tolerance.treatment == Treatment::kNote) return "note";
  std::string text;
  if (tolerance.relative > 0.0) {
    text = fmt::format("{:g} %", tolerance.relative * 100.0);
  }
  if (tolerance.absolute > 0.0) {
    text += fmt::format("{}{:g} {}", text.empty() ? "" : " + ",
                        tolerance.absolute, unit);
  }
  return text.empty() ? "exact" : text;
}

void Tolerances::set(std::string_view quantity, std::string_view text,
                     std::string_view code, const std::string& place) {
  const ToleranceRule* rule = find_rule(quantity);
  if (rule == nullptr) {
    throw Error(code, place, fmt::format("no quantity \"{}\"", quantity),
                "Known are " + known_quantities() + ".");
  }
  const auto tolerance = parse_tolerance(text, rule->unit);
  if (!tolerance) {
    throw Error(
        code, place,
        fmt::format("\"{}\" is no tolerance for {}", text, quantity),
        rule->unit.empty()
            ? "Write \"0.2 %\", \"note\" or \"off\"."
            : fmt::format("Write \"0.2 %\", \"0.01 {0}\", \"0.2 % + 0.01 "
                          "{0}\", \"note\" or \"off\".",
                          rule->unit));
  }
  replaced_[std::string(quantity)] = *tolerance;
}

const Tolerance& Tolerances::of(std::string_view quantity) const {
  const auto found = replaced_.find(quantity);
  return found != replaced_.end() ? found->second : rule_of(quantity).tolerance;
}

}  // namespace clevis::report
