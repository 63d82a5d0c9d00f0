#include "report/compare/comparison.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/messages/errors.h"

namespace clevis::report {
namespace {

/// How far `result` is from `baseline`; for texts 0 if they are equal, else
/// more than any tolerance.
double change_of(const ResultValue& result, const ResultValue& baseline) {
  if (result.index() != baseline.index()) return HUGE_VAL;
  if (const auto* number = std::get_if<double>(&result)) {
    return *number - std::get<double>(baseline);
  }
  if (const auto* point = std::get_if<std::array<double, 3>>(&result)) {
    const auto& other = std::get<std::array<double, 3>>(baseline);
    return std::hypot((*point)[0] - other[0], (*point)[1] - other[1],
                      (*point)[2] - other[2]);
  }
  return result == baseline ? 0.0 : HUGE_VAL;
}

double size_of(const ResultValue& value) {
  const auto* number = std::get_if<double>(&value);
  return number != nullptr ? std::abs(*number) : 0.0;
}

ComparisonRow compare_values(const std::string& subject,
                             const std::string& quantity,
                             const ResultValue& result,
                             const ResultValue& baseline,
                             const Tolerance& tolerance) {
  ComparisonRow row{subject, quantity, baseline, result};
  row.tolerance = tolerance;
  row.change = change_of(result, baseline);
  row.allowed = tolerance.relative * size_of(baseline) + tolerance.absolute;
  if (!(std::abs(row.change) <= row.allowed)) {
    row.outcome = tolerance.treatment == Treatment::kNote ? Outcome::kNoted
                                                          : Outcome::kMoved;
  }
  return row;
}

const Subject* find_subject(const StoredResult& result,
                            const std::string& name) {
  const auto found = std::ranges::find(result.subjects, name, &Subject::name);
  return found != result.subjects.end() ? &*found : nullptr;
}

void compare_subjects(const Subject& result, const Subject& baseline,
                      const Tolerances& tolerances,
                      std::vector<ComparisonRow>& rows) {
  for (const auto& [quantity, value] : baseline.values) {
    const Tolerance& tolerance = tolerances.of(quantity);
    if (tolerance.treatment == Treatment::kIgnore) continue;
    const auto found = result.values.find(quantity);
    if (found == result.values.end()) {
      ComparisonRow row{baseline.name, quantity, value, std::nullopt};
      row.tolerance = tolerance;
      row.outcome = Outcome::kMissing;
      rows.push_back(row);
    } else {
      rows.push_back(compare_values(baseline.name, quantity, found->second,
                                    value, tolerance));
    }
  }
  for (const auto& [quantity, value] : result.values) {
    const Tolerance& tolerance = tolerances.of(quantity);
    if (tolerance.treatment == Treatment::kIgnore ||
        baseline.values.contains(quantity)) {
      continue;
    }
    ComparisonRow row{result.name, quantity, std::nullopt, value};
    row.tolerance = tolerance;
    row.outcome = rule_of(quantity).since == Since::kLater ? Outcome::kNoted
                                                           : Outcome::kNew;
    rows.push_back(row);
  }
}

void refuse_mismatch(const StoredResult& result, const StoredResult& baseline) {
  if (result.scene != baseline.scene) {
    throw Error("R002", result.file.string(),
                fmt::format("the result is of scene \"{}\", the baseline of "
                            "scene \"{}\"",
                            result.scene, baseline.scene),
                "Compare results of the same scene.");
  }
  const auto holds = [](const StoredResult& stored, const char* kind) {
    return std::ranges::any_of(stored.subjects, [&](const Subject& subject) {
      return subject.name.starts_with(kind);
    });
  };
  const bool trains = holds(baseline, "transmission ");
  if (trains != holds(result, "transmission ")) {
    throw Error("R002", result.file.string(),
                "one of the two is of `clevis check`, the other of `clevis "
                "transmission`",
                "Compare results of the same command.");
  }
  if (!trains && !holds(baseline, "part ") && !holds(baseline, "bearing ")) {
    throw Error("R002", baseline.file.string(),
                "the baseline holds no part and no bearing, so nothing could "
                "be found out",
                "Make the baseline from a complete `clevis check`.");
  }
}

}  // namespace

Comparison compare(const StoredResult& result, const StoredResult& baseline,
                   const Tolerances& tolerances) {
  refuse_mismatch(result, baseline);
  Comparison comparison{baseline.scene, {}};
  const auto whole_subject = [&](const Subject& subject, Outcome outcome) {
    ComparisonRow row{subject.name, {}, {}, {}};
    row.outcome = outcome;
    comparison.rows.push_back(row);
  };
  for (const Subject& subject : baseline.subjects) {
    const Subject* other = find_subject(result, subject.name);
    if (other == nullptr) {
      whole_subject(subject, Outcome::kMissing);
    } else {
      compare_subjects(*other, subject, tolerances, comparison.rows);
    }
  }
  for (const Subject& subject : result.subjects) {
    if (find_subject(baseline, subject.name) == nullptr) {
      whole_subject(subject, Outcome::kNew);
    }
  }
  return comparison;
}

bool is_regression(const ComparisonRow& row) {
  return row.outcome != Outcome::kSame && row.outcome != Outcome::kNoted &&
         row.tolerance.treatment == Treatment::kCompare;
}

bool is_regression(const Comparison& comparison) {
  return std::ranges::any_of(comparison.rows, [](const ComparisonRow& row) {
    return is_regression(row);
  });
}

}  // namespace clevis::report
