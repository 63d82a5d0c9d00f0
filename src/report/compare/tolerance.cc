#include "report/compare/tolerance.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "base/messages/errors.h"

namespace clevis::report {
namespace {

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
  for (const ToleranceRule& rule : tolerance_rules()) {
    list += (list.empty() ? "" : ", ") + rule.quantity;
  }
  return list;
}

const ToleranceRule* find_rule(std::string_view quantity) {
  const auto rules = tolerance_rules();
  const auto found =
      std::ranges::find(rules, quantity, &ToleranceRule::quantity);
  return found != rules.end() ? &*found : nullptr;
}

}  // namespace

const ToleranceRule& rule_of(std::string_view quantity) {
  const ToleranceRule* rule = find_rule(quantity);
  assert(rule != nullptr && "quantity without a rule");
  return *rule;
}

std::optional<Tolerance> parse_tolerance(std::string_view text,
                                         std::string_view unit) {
  if (text == "off") return Tolerance{Treatment::kIgnore, 0, 0};
  if (text == "note") return Tolerance{Treatment::kNote, 0, 0};
  Tolerance tolerance = compare_within(0.0, 0.0);
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
