#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/compare/result_reader.h"
#include "report/compare/tolerance.h"

namespace clevis::report {

enum class Outcome {
  kSame,     ///< within the tolerance
  kMoved,    ///< above it
  kNoted,    ///< moved, but only noted, or added after the baseline was made
  kMissing,  ///< in the baseline, not in the result
  kNew,      ///< in the result, not in the baseline
};

/// One quantity of result and baseline side by side.
struct ComparisonRow {
  std::string subject;
  std::string quantity;  ///< empty: the whole subject is missing or new
  std::optional<ResultValue> baseline, result;
  double change{};   ///< result − baseline, or the distance of two points
  double allowed{};  ///< largest |change|
  Tolerance tolerance{};
  Outcome outcome{};
};

struct Comparison {
  std::string scene;
  std::vector<ComparisonRow> rows;
};

/// Holds a result against its baseline, quantity by quantity.
///
/// Parts, joints, drives and probes that only one side has are regressions:
/// who stops checking a part must say so by renewing the baseline.
/// @throws Error R002 if the two are of different scenes, or the baseline
///   holds neither part nor bearing.
Comparison compare(const StoredResult& result, const StoredResult& baseline,
                   const Tolerances& tolerances);

/// Whether the row makes the comparison a regression.
bool is_regression(const ComparisonRow& row);
bool is_regression(const Comparison& comparison);

}  // namespace clevis::report
