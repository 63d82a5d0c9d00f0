#pragma once

#include <fstream>
#include <string>

#include "report/check/result_json.h"
#include "report/compare/comparison.h"
#include "report/compare/result_reader.h"
#include "unit/report/sample_report.h"

namespace clevis::report {

/// Through the file, as the user's results go.
inline StoredResult stored(const CheckReport& report) {
  const TestFolder folder;
  std::ofstream(folder / "result.json") << result_json(report);
  return read_result(folder.path());
}

inline Comparison compare_with_sample(const CheckReport& changed) {
  return compare(stored(changed), stored(sample_report()), {});
}

/// "part DCE peak_von_mises, part DCE band_low": what makes it a regression.
inline std::string regressions(const Comparison& comparison) {
  std::string list;
  for (const ComparisonRow& row : comparison.rows) {
    if (!is_regression(row)) continue;
    list += (list.empty() ? "" : ", ") + row.subject;
    if (!row.quantity.empty()) list += " " + row.quantity;
  }
  return list;
}

template <typename Change>
std::string regressions_after(Change change) {
  CheckReport report = sample_report();
  change(report, report.parts[0]);
  return regressions(compare_with_sample(report));
}

}  // namespace clevis::report
