#include "report/compare/rules.h"

#include <algorithm>
#include <vector>

#include "report/check/check_quantities.h"
#include "report/machine/bearing_quantities.h"
#include "report/parts/impact_quantities.h"
#include "report/parts/limit_quantities.h"
#include "report/parts/part_quantities.h"
#include "report/parts/probe_quantities.h"
#include "report/summary/mechanism_quantities.h"

namespace clevis::report {
namespace {

constexpr Rule kClosedFormRule = {compare_within(1e-9, 0.0), "as ratio"};

void add(const std::string& subject, const QuantityRow& row,
         std::vector<ToleranceRule>& rules) {
  const auto known =
      std::ranges::find(rules, row.name, &ToleranceRule::quantity);
  if (known != rules.end()) {
    known->subjects += ", " + subject;
    return;
  }
  rules.push_back({row.name, row.unit == "1" ? "" : row.unit, subject,
                   row.compare->tolerance, row.compare->reason, row.since});
}

template <class Subject>
void add(const std::string& name, const Quantities<Subject>& rows,
         std::vector<ToleranceRule>& rules) {
  for (const QuantityRow& row : rows) {
    if (row.compare) add(name, row, rules);
  }
}

/// Their units are those of the transmission's output.
std::vector<QuantityRow> transmission_rows() {
  return {{"ratio", "", "", "",
           Rule{compare_within(1e-9, 0.0), "closed forms: only round-off"}},
          {"compliance", "", "", "", kClosedFormRule},
          {"last_stage", "", "", "", kClosedFormRule},
          {"frequency", "", "Hz", "", kClosedFormRule},
          {"worst_case", "", "", "", kClosedFormRule},
          {"root_of_squares", "", "", "", kClosedFormRule},
          {"reversal", "", "", "", kClosedFormRule},
          {"reversal_run", "", "", "",
           Rule{compare_within(1e-6, 0.0),
                "a run in small steps: its round-off adds up"}}};
}

std::vector<ToleranceRule> all_rules() {
  std::vector<ToleranceRule> rules;
  add("check", check_quantities(), rules);
  add("mechanism", mechanism_quantities(), rules);
  add("joint", joint_quantities(), rules);
  add("drive", drive_quantities(), rules);
  add("part", part_quantities(), rules);
  add("limits", limit_quantities(), rules);
  add("impact", blow_quantities(), rules);
  add("model of an impact", blow_model_quantities(), rules);
  add("vibration", vibration_quantities(), rules);
  add("probe", probe_quantities(), rules);
  add("bearing", bearing_quantities(), rules);
  for (const QuantityRow& row : transmission_rows()) {
    add("transmission", row, rules);
  }
  return rules;
}

}  // namespace

std::span<const ToleranceRule> tolerance_rules() {
  static const std::vector<ToleranceRule> rules = all_rules();
  return rules;
}

}  // namespace clevis::report
