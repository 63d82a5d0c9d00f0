#include "report/check/check_junit.h"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "part/verdict.h"
#include "report/parts/buckling_output.h"
#include "report/parts/peak_quantities.h"
#include "report/text/junit.h"
#include "report/text/units.h"

namespace clevis::report {
namespace {

using assessment::PartResult;
using assessment::PeakVerdict;
using part::Verdict;

/// The part's own words, where the case needs an explanation.
std::string reason(JunitStatus status, const PartResult& part) {
  const bool silent = status == JunitStatus::kPassed || part.why.empty();
  return silent ? "" : "; " + part.why;
}

/// A limit that is kept says nothing as long as the part is not judged.
JunitStatus status_of_limit(bool exceeded, const PartResult& part) {
  if (exceeded && part.verdict == Verdict::kFail) {
    return JunitStatus::kFailure;
  }
  return part.verdict == Verdict::kNotJudged ? JunitStatus::kError
                                             : JunitStatus::kPassed;
}

/// A regular peak may decide though its band is wider than the tolerance.
bool is_settled(const PartResult& part) {
  return part.peak.verdict == PeakVerdict::kConverged ||
         (part.peak.verdict == PeakVerdict::kNotConverged &&
          part.verdict != Verdict::kNotJudged);
}

JunitCase convergence_case(const PartResult& part) {
  const assessment::PeakStress& peak = part.peak;
  return {
      .classname = {},
      .name = "convergence",
      .status = is_settled(part) ? JunitStatus::kPassed : JunitStatus::kError,
      .message = fmt::format(
          "peak von Mises {:.6g} MPa, band [{:.6g}, {:.6g}] MPa at {}: {}",
          megapascals(peak.value), megapascals(peak.band_low),
          megapascals(peak.band_high), peak.group, text(peak.verdict)),
      .seconds = part.seconds.total};
}

JunitCase safety_case(const PartResult& part, const part::Limits& limits) {
  const std::string factor =
      fmt::format("safety factor {:.6g}{}", part.safety_factor,
                  part.vibration.governs ? " as it vibrates" : "");
  JunitCase test{.classname = {},
                 .name = "safety factor",
                 .status = JunitStatus::kSkipped,
                 .message = factor + ", no limit set",
                 .seconds = 0.0};
  if (limits.safety_factor) {
    test.status =
        status_of_limit(part.safety_factor < *limits.safety_factor, part);
    test.message =
        fmt::format("{}, at least {:.6g} wanted{}", factor,
                    *limits.safety_factor, reason(test.status, part));
  }
  return test;
}

JunitCase deflection_case(const PartResult& part, const part::Limits& limits) {
  const double deflection = millimetres(part.deflection);
  JunitCase test{
      .classname = {},
      .name = "deflection",
      .status = JunitStatus::kSkipped,
      .message = fmt::format("deflection {:.6g} mm, no limit set", deflection),
      .seconds = 0.0};
  if (limits.deflection) {
    test.status = status_of_limit(
        (part.deflection_low > 0.0 ? part.deflection_low : part.deflection) >
            *limits.deflection,
        part);
    test.message = fmt::format(
        "deflection {:.6g} mm, band [{:.6g}, {:.6g}] mm, at most {:.6g} mm "
        "allowed{}",
        deflection, millimetres(part.deflection_low),
        millimetres(part.deflection_high), millimetres(*limits.deflection),
        reason(test.status, part));
  }
  return test;
}

std::vector<JunitCase> part_cases(const PartResult& part,
                                  const part::Limits& limits) {
  std::vector<JunitCase> cases = {
      convergence_case(part), safety_case(part, limits),
      deflection_case(part, limits), buckling_case(part, limits)};
  const auto shows = [&](JunitStatus status) {
    return std::ranges::find(cases, status, &JunitCase::status) != cases.end();
  };
  const bool fails = part.verdict == Verdict::kFail;
  const bool unjudged = part.verdict == Verdict::kNotJudged;
  if (fails && !shows(JunitStatus::kFailure)) {
    cases.push_back({{}, "verdict", JunitStatus::kFailure, part.why, 0.0});
  }
  if (unjudged && !shows(JunitStatus::kError)) {
    cases.push_back({{}, "verdict", JunitStatus::kError, part.why, 0.0});
  }
  for (JunitCase& test : cases) test.classname = "clevis." + part.name;
  return cases;
}

/// Static safety, and life if one is wanted; what the formulas leave open is
/// an error.
std::vector<JunitCase> bearing_cases(const BearingReport& bearing) {
  constexpr double kHour = 3600.0;
  const machine::BearingResult& r = bearing.result;
  const auto status = [&r](bool fails) {
    if (fails) return JunitStatus::kFailure;
    return r.verdict == Verdict::kNotJudged ? JunitStatus::kError
                                            : JunitStatus::kPassed;
  };
  const bool breaks =
      r.static_safety && *r.static_safety < r.static_safety_wanted;
  const std::string name = "clevis.bearing." + r.name;
  std::vector<JunitCase> cases{
      {name, "static safety", status(breaks),
       fmt::format("P0 {:.6g} N, C0 {:.6g} N, C0/P0 at least {:.6g} wanted{}",
                   r.static_load, r.static_rating, r.static_safety_wanted,
                   r.why.empty() ? "" : "; " + r.why),
       0.0}};
  if (r.life_wanted) {
    const bool tires = r.life_seconds && *r.life_seconds < *r.life_wanted;
    cases.push_back(
        {name, "life", status(tires),
         fmt::format("L10 {} h, at least {:.6g} h wanted",
                     r.life_seconds
                         ? fmt::format("{:.6g}", *r.life_seconds / kHour)
                         : "without bound",
                     *r.life_wanted / kHour),
         0.0});
  }
  return cases;
}

}  // namespace

std::string check_junit(const CheckReport& report) {
  std::vector<JunitCase> cases;
  for (const PartResult& part : report.parts) {
    const auto found = report.limits.find(part.name);
    const auto limits =
        found != report.limits.end() ? found->second : part::Limits{};
    std::ranges::move(part_cases(part, limits), std::back_inserter(cases));
  }
  for (const BearingReport& bearing : report.bearings) {
    std::ranges::move(bearing_cases(bearing), std::back_inserter(cases));
  }
  for (const PartFailure& failure : report.failures) {
    cases.push_back(
        {"clevis." + failure.name, "computation", JunitStatus::kError,
         fmt::format("{} {}", failure.error.what(), failure.error.remedy()),
         0.0});
  }
  if (!report.complete) {
    cases.push_back({"clevis", "completeness", JunitStatus::kError,
                     "the check was interrupted: parts are missing", 0.0});
  }
  return junit_xml(report.scene, cases);
}

}  // namespace clevis::report
