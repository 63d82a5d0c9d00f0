#include "report/parts/buckling_output.h"

#include <numbers>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "part/buckling_limit.h"

namespace clevis::report {
namespace {

using assessment::BucklingResult;
using nlohmann::ordered_json;

ordered_json above_zero(double value) {
  return value > 0.0 ? ordered_json(value) : ordered_json();
}

double degrees(double radians) {
  return radians * 180.0 / std::numbers::pi;
}

/// Nothing below it was found.
bool is_bound(const BucklingResult& buckling) {
  return buckling.band_low == buckling.band_high;
}

std::string factor_text(const BucklingResult& buckling) {
  if (is_bound(buckling)) return fmt::format("above {:.4g}", buckling.factor);
  return fmt::format("{:.4g} [{:.4g}, {:.4g}]", buckling.factor,
                     buckling.band_low, buckling.band_high);
}

}  // namespace

std::string buckling_text(const BucklingResult& buckling) {
  if (buckling.factor == 0.0) {
    return buckling.remark.empty() ? "" : "buckling: " + buckling.remark;
  }
  std::string line = fmt::format("buckling {} times the loads of {}",
                                 factor_text(buckling), buckling.label);
  if (buckling.euler > 0.0) {
    line += fmt::format(" (Euler's strut {:.4g})", buckling.euler);
  }
  if (!buckling.remark.empty()) line += "; " + buckling.remark;
  return line;
}

ordered_json buckling_json(const BucklingResult& buckling) {
  if (buckling.factor == 0.0 && buckling.remark.empty()) return {};
  ordered_json band;  // null: not computed
  if (buckling.factor > 0.0) band = {buckling.band_low, buckling.band_high};
  return {{"factor", above_zero(buckling.factor)},
          {"band", band},
          {"is_lower_bound", buckling.factor > 0.0 && is_bound(buckling)},
          {"instant_s", buckling.instant},
          {"case", buckling.label},
          {"model", buckling.model},
          {"remark", buckling.remark},
          {"euler", above_zero(buckling.euler)}};
}

ordered_json finite_motion_json(const assessment::FiniteMotion& motion) {
  return {{"rotation_deg", degrees(motion.rotation)},
          {"strain_percent", 100.0 * motion.strain},
          {"case", motion.label}};
}

std::vector<std::pair<std::string, std::string>> buckling_columns(
    const assessment::PartResult& part) {
  const auto number = [](double value) {
    return value > 0.0 ? fmt::format("{}", value) : std::string();
  };
  return {{"buckling_factor[1]", number(part.buckling.factor)},
          {"buckling_low[1]", number(part.buckling.band_low)},
          {"buckling_high[1]", number(part.buckling.band_high)},
          {"buckling_case", part.buckling.label},
          {"euler_factor[1]", number(part.buckling.euler)},
          {"rotation[deg]",
           fmt::format("{}", degrees(part.finite_motion.rotation))}};
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
  const bool fails = buckling.factor > 0.0 && buckling.band_high < wanted &&
                     !is_bound(buckling);
  if (fails || buckling.euler_fails(wanted)) {
    test.status = JunitStatus::kFailure;
  } else if (buckling.factor == 0.0) {
    test.status = JunitStatus::kSkipped;
  } else if (buckling.band_low < wanted) {
    test.status = JunitStatus::kError;
  } else {
    test.status = JunitStatus::kPassed;
  }
  return test;
}

}  // namespace clevis::report
