#include "report/compare/comparison_output.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "report/check/result_json.h"
#include "report/text/json_text.h"
#include "report/text/junit.h"
#include "report/text/text_table.h"

namespace clevis::report {
namespace {

using nlohmann::ordered_json;

std::string value_text(const std::optional<ResultValue>& value) {
  if (!value) return "-";
  if (const auto* number = std::get_if<double>(&*value)) {
    return fmt::format("{:.7g}", *number);
  }
  if (const auto* point = std::get_if<std::array<double, 3>>(&*value)) {
    return fmt::format("({:.3f}, {:.3f}, {:.3f})", (*point)[0], (*point)[1],
                       (*point)[2]);
  }
  return std::get<std::string>(*value);
}

std::string unit_of(const ComparisonRow& row) {
  return row.quantity.empty() ? "" : std::string(rule_of(row.quantity).unit);
}

/// Relative to the baseline where that makes sense.
std::string change_text(const ComparisonRow& row) {
  if (!row.baseline || !row.result || !std::isfinite(row.change)) return "-";
  const auto* baseline = std::get_if<double>(&*row.baseline);
  if (baseline != nullptr && *baseline != 0.0) {
    return fmt::format("{:+.3g} %", 100.0 * row.change / std::abs(*baseline));
  }
  return fmt::format("{:+.3g} {}", row.change, unit_of(row));
}

std::string outcome_text(Outcome outcome) {
  switch (outcome) {
    case Outcome::kSame:
      return "same";
    case Outcome::kMoved:
      return "moved";
    case Outcome::kNoted:
      return "noted";
    case Outcome::kMissing:
      return "missing";
    case Outcome::kNew:
      return "new";
  }
  return {};
}

std::string tolerance_text(const ComparisonRow& row) {
  return row.quantity.empty() ? "exact" : text(row.tolerance, unit_of(row));
}

/// "part DCE" -> "all of it" where a whole subject is concerned.
std::string quantity_text(const ComparisonRow& row) {
  if (row.quantity.empty()) return "all of it";
  const std::string unit = unit_of(row);
  return unit.empty() ? row.quantity : row.quantity + " [" + unit + "]";
}

std::string summary(const Comparison& comparison) {
  const auto regressions =
      std::ranges::count_if(comparison.rows, [](const ComparisonRow& row) {
        return is_regression(row);
      });
  if (regressions > 0) {
    return fmt::format("{} of {} quantities moved: regression (R001)",
                       regressions, comparison.rows.size());
  }
  double largest = 0.0;
  for (const ComparisonRow& row : comparison.rows) {
    if (row.outcome == Outcome::kSame && row.allowed > 0.0) {
      largest = std::max(largest, std::abs(row.change) / row.allowed);
    }
  }
  return fmt::format(
      "{} quantities within their tolerances, the largest change takes {:.2g} "
      "% of its own",
      comparison.rows.size(), 100.0 * largest);
}

ordered_json value_json(const std::optional<ResultValue>& value) {
  if (!value) return nullptr;
  return std::visit(
      [](const auto& held) {
        return ordered_json(held);
      },
      *value);
}

}  // namespace

std::string comparison_table(const Comparison& comparison, Colour colour) {
  TextTable table({{"of"},
                   {"quantity"},
                   {"baseline", Align::kRight},
                   {"result", Align::kRight},
                   {"change", Align::kRight},
                   {"tolerance"},
                   {"verdict"}});
  bool any = false;
  for (const ComparisonRow& row : comparison.rows) {
    if (row.outcome == Outcome::kSame) continue;
    any = true;
    table.add_row({{row.subject},
                   {quantity_text(row)},
                   {value_text(row.baseline)},
                   {value_text(row.result)},
                   {change_text(row)},
                   {tolerance_text(row)},
                   {outcome_text(row.outcome),
                    is_regression(row) ? Tone::kBad : Tone::kDoubtful}});
  }
  const std::string lines =
      any ? fmt::format("\n{}\n", table.text(colour)) : std::string();
  return fmt::format("{}\n{}{}\n", printable(comparison.scene), lines,
                     summary(comparison));
}

std::string comparison_json(const Comparison& comparison) {
  ordered_json moved = ordered_json::array();
  for (const ComparisonRow& row : comparison.rows) {
    if (row.outcome == Outcome::kSame) continue;
    moved.push_back({{"of", row.subject},
                     {"quantity", row.quantity},
                     {"unit", unit_of(row)},
                     {"baseline", value_json(row.baseline)},
                     {"result", value_json(row.result)},
                     {"tolerance", tolerance_text(row)},
                     {"outcome", outcome_text(row.outcome)},
                     {"regression", is_regression(row)}});
  }
  return json_text(
      {{"schema", kSchema},
       {"scene", comparison.scene},
       {"verdict", is_regression(comparison) ? "regression" : "same"},
       {"quantities", comparison.rows.size()},
       {"moved", moved}});
}

std::string comparison_junit(const Comparison& comparison) {
  std::vector<JunitCase> cases;
  for (const ComparisonRow& row : comparison.rows) {
    cases.push_back(
        {"clevis.compare." + row.subject, quantity_text(row),
         is_regression(row) ? JunitStatus::kFailure : JunitStatus::kPassed,
         fmt::format("{}: baseline {}, result {}, change {}, tolerance {}",
                     outcome_text(row.outcome), value_text(row.baseline),
                     value_text(row.result), change_text(row),
                     tolerance_text(row)),
         0.0});
  }
  return junit_xml("compare: " + comparison.scene, cases);
}

}  // namespace clevis::report
