#include "report/check/check_report.h"

#include <algorithm>

#include "part/part_definition.h"
#include "part/verdict.h"

namespace clevis::report {

using assessment::PartResult;
using assessment::PeakVerdict;
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

std::string_view text(PeakVerdict verdict) {
  switch (verdict) {
    case PeakVerdict::kConverged:
      return "converged";
    case PeakVerdict::kSingular:
      return "singular";
    case PeakVerdict::kNotConverged:
      break;
  }
  return "not converged";
}

bool is_displacement(const assessment::ProbeResult& probe) {
  return part::is_displacement(probe.quantity);
}

}  // namespace clevis::report
