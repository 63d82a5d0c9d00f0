#include "report/check/check_report.h"

#include <algorithm>

namespace clevis::report {

using assessment::PartResult;
using assessment::PartVerdict;
using assessment::PeakVerdict;

PartVerdict overall_verdict(const CheckReport& report) {
  const auto any = [&](PartVerdict verdict) {
    return std::ranges::find(report.parts, verdict, &PartResult::verdict) !=
           report.parts.end();
  };
  const auto any_bearing = [&](machine::BearingVerdict verdict) {
    return std::ranges::any_of(report.bearings, [&](const auto& bearing) {
      return bearing.result.verdict == verdict;
    });
  };
  using machine::BearingVerdict;
  if (any(PartVerdict::kFail) || any_bearing(BearingVerdict::kFail)) {
    return PartVerdict::kFail;
  }
  // No part at all is no reason to say that the parts hold.
  if (any(PartVerdict::kNotJudged) || any_bearing(BearingVerdict::kNotJudged) ||
      !report.failures.empty() || !report.complete || report.parts.empty()) {
    return PartVerdict::kNotJudged;
  }
  return PartVerdict::kPass;
}

ExitCode exit_code(const CheckReport& report) {
  if (!report.failures.empty()) return report.failures[0].error.exit_code();
  switch (overall_verdict(report)) {
    case PartVerdict::kPass:
      return ExitCode::kPass;
    case PartVerdict::kFail:
      return ExitCode::kLimitExceeded;
    case PartVerdict::kNotJudged:
      break;
  }
  return ExitCode::kNotJudged;
}

std::string_view text(PartVerdict verdict) {
  switch (verdict) {
    case PartVerdict::kPass:
      return "pass";
    case PartVerdict::kFail:
      return "fail";
    case PartVerdict::kNotJudged:
      break;
  }
  return "not judged";
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
  return probe.quantity.starts_with("displacement");
}

}  // namespace clevis::report
