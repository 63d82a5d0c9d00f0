#include "assessment/joined/joined_parts.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "assessment/buckling/buckling_check.h"
#include "assessment/pace/load_pace.h"
#include "assessment/second_order/second_order_check.h"
#include "assessment/verdict/governing_peak.h"
#include "assessment/verdict/verdict.h"
#include "assessment/vibration/duration_ratio.h"

namespace clevis::assessment {
namespace {

constexpr double kCounts = 0.98;  // of a square or a factor: less is no change

/// A part with its job.
struct Member {
  const PartJob* job;
  PartResult* result;
};

std::vector<Member> members_of(const std::vector<std::string>& names,
                               const std::vector<PartJob>& jobs,
                               std::vector<PartResult>& results) {
  std::vector<Member> members;
  for (const std::string& name : names) {
    const auto job = std::ranges::find(
        jobs, name,
        [](const PartJob& j) -> const auto& { return j.part.name; });
    const auto result = std::ranges::find(results, name, &PartResult::name);
    if (job == jobs.end() || result == results.end()) continue;
    members.push_back({&*job, &*result});
  }
  return members;
}

/// The others that yield, for a message.
std::string others(const std::vector<Member>& members, const Member& but) {
  std::vector<std::string> names;
  for (const Member& member : members) {
    if (member.result != but.result) names.push_back(member.result->name);
  }
  return fmt::format("{}", fmt::join(names, " and "));
}

using PeriodOf = std::optional<double> (*)(const PartResult&);

std::optional<double> first_of_all(const PartResult& result) {
  return result.first_period;
}

/// Why the vibration of one of the members is not known; empty: it is.
/// @param counts  a rise from which on it may be [1].
std::string not_known_joined(const std::vector<Member>& members,
                             const Member& member, double counts,
                             PeriodOf period_of) {
  double squares = 0.0;  // [s²]
  for (const Member& any : members) {
    squares += std::pow(period_of(*any.result).value_or(0.0), 2);
  }
  const double first = period_of(*member.result).value_or(0.0);
  const double low = first * first / squares;
  if (!(first > 0.0) || low > kCounts) return {};
  for (const LoadSet& set : member.job->load_sets) {
    const LoadSet motion = followed_loads(set);
    const double rise = rise_near(
        *member.job, load_components(*member.job, motion), first, low, 1.0);
    if (rise <= counts ||
        !rise_decides(member.job->part, *member.result, rise)) {
      continue;
    }
    return fmt::format(
        "{} joined to it yields, too, which may lower its frequency from "
        "{:.4g} to {:.4g} Hz, where it may swing {:.2g} times as far",
        others(members, member), 1.0 / first, 1.0 / std::sqrt(squares), rise);
  }
  return {};
}

/// The lowest factor of all members together at the least [1].
double factor_together(const std::vector<Member>& members) {
  double sum = 0.0;
  for (const Member& member : members) {
    const BucklingResult& buckling = member.result->buckling;
    if (buckling.factor) sum += 1.0 / buckling.band_low;
  }
  return 1.0 / sum;
}

void lower_buckling(const std::vector<Member>& members, const Member& member,
                    double together) {
  PartResult& result = *member.result;
  BucklingResult& buckling = result.buckling;
  const double own = buckling.band_low;
  buckling.band_low = together;
  const std::string more =
      fmt::format("{} joined to it yields, too: together at {:.4g} or later",
                  others(members, member), together);
  buckling.remark += (buckling.remark.empty() ? "" : "; ") + more;
  const double counted =
      result.second_order.peak > 0.0 ? bent_further(own) : 1.0;
  bound_by_buckling_together(together, counted, more, result);
}

}  // namespace

std::vector<std::string> doubt_by_joined(const std::vector<PartJob>& jobs,
                                         const JoinedParts& joined,
                                         std::vector<PartResult>& results) {
  // Across hinges bending is not handed on: only a load that repeats itself at
  // a frequency finds one, to which pulses and steps answer 1 to 2.
  constexpr double kAcrossHinges = 2.0;
  std::vector<Member> changed;
  const auto doubt_vibration = [&](const std::vector<std::string>& names,
                                   double counts) {
    const auto members = members_of(names, jobs, results);
    for (const Member& member : members) {
      VibrationResult& vibration = member.result->vibration;
      for (const PeriodOf period : {first_of_all, first_excited}) {
        if (!vibration.not_followed.empty()) break;
        vibration.not_followed =
            not_known_joined(members, member, counts, period);
        if (!vibration.not_followed.empty()) changed.push_back(member);
      }
    }
  };
  for (const auto& names : joined.stiffly) doubt_vibration(names, kRiseCounts);
  for (const auto& names : joined.moving) doubt_vibration(names, kAcrossHinges);
  for (const auto& names : joined.elastically) {
    const auto members = members_of(names, jobs, results);
    const double together = factor_together(members);
    for (const Member& member : members) {
      const BucklingResult& buckling = member.result->buckling;
      const double enough = enough_buckling(member.job->part.limits);
      if (!buckling.factor || together >= kCounts * buckling.band_low ||
          together >= enough) {
        continue;
      }
      lower_buckling(members, member, together);
      changed.push_back(member);
    }
  }
  std::vector<std::string> names;
  for (const Member& member : changed) {
    const part::Verdict before = member.result->verdict;
    if (before == part::Verdict::kFail) continue;  // a doubt mends nothing
    judge(member.job->part, *member.result);
    if (member.result->verdict != before) names.push_back(member.result->name);
  }
  return names;
}

}  // namespace clevis::assessment
