#include "assessment/verdict/stability_limits.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "assessment/verdict/governing_peak.h"
#include "part/buckling_limit.h"
#include "part/verdict.h"

namespace clevis::assessment {
namespace {

constexpr double kMega = 1e6;

std::optional<Judgement> judge_euler(double wanted, const PartResult& result) {
  if (!result.buckling.euler_fails(wanted)) return std::nullopt;
  return Judgement{
      part::Verdict::kFail,
      fmt::format("buckling: Euler's load is {:.3g} times the compression, "
                  "{:.4g} is wanted",
                  *result.buckling.euler, wanted)};
}

/// Loads of which vibration makes more buckle the part sooner, if they last.
std::optional<Judgement> judge_swinging_buckling(double wanted,
                                                 const PartResult& result) {
  const BucklingResult& buckling = result.buckling;
  if (result.swings.empty() || !buckling.factor) return std::nullopt;
  const double low = buckling.band_low / *buckling.factor;
  for (std::size_t s = 0; s < buckling.of_motions.size(); ++s) {
    const double factor = buckling.of_motions[s];
    const double swing = result.swings[s].largest();
    if (low * factor >= swing * wanted) continue;
    return Judgement{
        part::Verdict::kNotJudged,
        fmt::format(
            "buckling: {:.4g} times the loads of its motion at rest, of "
            "which vibration makes {:.4g} times as much; {:.4g} is "
            "wanted",
            factor, swing, wanted)};
  }
  return std::nullopt;
}

/// Of a case that one pin holds: what else may hold it.
std::string free_end(const part::PartDefinition& part,
                     const BucklingResult& buckling) {
  const bool is_held_by_one =
      std::ranges::any_of(part.cases, [&](const auto& load_case) {
        return load_case.name == buckling.label &&
               load_case.held_by_pin.size() == 1 && !load_case.pins.empty();
      });
  if (!is_held_by_one) return "";
  return ". Where its loads act it is free to move sideways: if pins guide it "
         "there, give all forces under `pins` and no `held_by_pin`";
}

}  // namespace

std::optional<Judgement> judge_second_order(const part::PartDefinition& part,
                                            const PartResult& result) {
  const SecondOrderResult& found = result.second_order;
  if (!found.is_stable) {
    return Judgement{
        part::Verdict::kNotJudged,
        fmt::format("its loads and its spin ({}) bend it further and further: "
                    "linear theory has no stress for it",
                    found.label)};
  }
  if (!found.bears_growth) {
    return Judgement{
        part::Verdict::kNotJudged,
        fmt::format("buckling: {:.4g} times the loads of {}, with as much more "
                    "of what its spin makes of them, may be more than it bears",
                    part::wanted_buckling_factor(part.limits), found.label)};
  }
  const double admitted = admitted_peak(part, result);
  if (!found.failure.empty()) {
    return Judgement{
        part::Verdict::kNotJudged,
        "how far its loads bend it further is not known: " + found.failure};
  }
  if (std::max(found.peak, found.bound) <= admitted) return std::nullopt;
  const PeakStress peak = governing_peak(result);
  const double allowed = allowed_stress(part);
  // The product with vibration is an upper bound: it decides nothing.
  const bool fails = found.least_peak * peak.band_low > allowed * peak.value;
  return Judgement{
      fails ? part::Verdict::kFail : part::Verdict::kNotJudged,
      fails ? fmt::format("its loads act on what they displace: {:.4g} MPa "
                          "({:.4g} of linear theory, {}) exceeds {:.4g} MPa",
                          found.peak / kMega, found.stress, found.label,
                          allowed / kMega)
            : fmt::format("its loads act on what they displace: {:.4g} MPa at "
                          "most, {:.4g} MPa are allowed",
                          std::max(found.peak, found.bound) / kMega * allowed /
                              admitted,
                          allowed / kMega)};
}

std::optional<Judgement> judge_buckling(const part::PartDefinition& part,
                                        const PartResult& result) {
  const double wanted = part::wanted_buckling_factor(part.limits);
  const BucklingResult& buckling = result.buckling;
  if (auto against = judge_euler(wanted, result)) return against;
  const bool is_open = !buckling.factor && !buckling.remark.empty();
  // Without a limit of the user's own Euler's strut is enough.
  if (is_open && (part.limits.buckling || !buckling.euler)) {
    return Judgement{
        part::Verdict::kNotJudged,
        "the limit of buckling is not held against: " + buckling.remark};
  }
  if (!buckling.factor || buckling.band_low >= wanted) {
    return judge_swinging_buckling(wanted, result);
  }
  const bool fails = buckling.band_high < wanted;
  const std::string doubt = fails                     ? ""
                            : buckling.remark.empty() ? ": mesh finer"
                                                      : ": " + buckling.remark;
  return Judgement{
      fails ? part::Verdict::kFail : part::Verdict::kNotJudged,
      fmt::format("buckling: the part buckles under {:.4g} [{:.4g}, {:.4g}] "
                  "times the loads of {}, {:.4g} is wanted{}{}",
                  *buckling.factor, buckling.band_low, buckling.band_high,
                  buckling.label, wanted, doubt, free_end(part, buckling))};
}

}  // namespace clevis::assessment
