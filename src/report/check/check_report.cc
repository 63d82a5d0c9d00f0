#include "report/check/check_report.h"

#include <algorithm>

#include "part/verdict.h"

namespace clevis::report {

using assessment::PartResult;
using part::Verdict;

part::Verdict overall_verdict(const CheckReport& report) {
  const auto any = [&](part::Verdict verdict) {
    return std::ranges::find(report.parts, verdict, &PartResult::verdict) !=
           report.parts.end();
  };
  const auto any_bearing = [&](part::Verdict verdict) {
    return std::ranges::any_of(report.bearings, [&](const auto& bearing) {
      return bearing.result.verdict == verdict;
    });
  };
  if (any(Verdict::kFail) || any_bearing(Verdict::kFail)) {
    return Verdict::kFail;
  }
  // No part at all is no reason to say that the parts hold.
  if (any(Verdict::kNotJudged) || any_bearing(Verdict::kNotJudged) ||
      !report.failures.empty() || !report.complete || report.parts.empty()) {
    return Verdict::kNotJudged;
  }
  return Verdict::kPass;
}

ExitCode exit_code(const CheckReport& report) {
  if (!report.failures.empty()) return report.failures[0].error.exit_code();
  switch (overall_verdict(report)) {
    case Verdict::kPass:
      return ExitCode::kPass;
    case Verdict::kFail:
      return ExitCode::kLimitExceeded;
    case Verdict::kNotJudged:
      break;
  }
  return ExitCode::kNotJudged;
}

}  // namespace clevis::report
