#include "report/parts/buckling_output.h"

#include <fmt/format.h>

#include "part/buckling_limit.h"

namespace clevis::report {
namespace {

using assessment::BucklingResult;

std::string factor_text(const BucklingResult& buckling) {
  if (buckling.is_lower_bound()) {
    return fmt::format("above {:.4g}", *buckling.factor);
  }
  return fmt::format("{:.4g} [{:.4g}, {:.4g}]", *buckling.factor,
                     buckling.band_low, buckling.band_high);
}

}  // namespace

std::string buckling_text(const BucklingResult& buckling) {
  if (!buckling.factor) {
    return buckling.remark.empty() ? "" : "buckling: " + buckling.remark;
  }
  std::string line = fmt::format("buckling {} times the loads of {}",
                                 factor_text(buckling), buckling.label);
  if (buckling.euler) {
    line += fmt::format(" (Euler's strut {:.4g})", *buckling.euler);
  }
  if (!buckling.remark.empty()) line += "; " + buckling.remark;
  return line;
}

JunitCase buckling_case(const assessment::PartResult& part,
                        const part::Limits& limits) {
  const BucklingResult& buckling = part.buckling;
  const double wanted = part::wanted_buckling_factor(limits);
  JunitCase test{.classname = {},
                 .name = "buckling",
                 .status = JunitStatus::kSkipped,
                 .message = "nothing is known of its buckling",
                 .seconds = 0.0};
  const std::string text = buckling_text(buckling);
  if (text.empty()) return test;
  test.message = fmt::format("{}, at least {:.4g} wanted", text, wanted);
  const bool fails = buckling.factor && buckling.band_high < wanted &&
                     !buckling.is_lower_bound();
  if (fails || buckling.euler_fails(wanted)) {
    test.status = JunitStatus::kFailure;
  } else if (!buckling.factor) {
    test.status = JunitStatus::kSkipped;
  } else if (buckling.band_low < wanted) {
    test.status = JunitStatus::kError;
  } else {
    test.status = JunitStatus::kPassed;
  }
  return test;
}

}  // namespace clevis::report
