#include "machine/bearings/bearing_life.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <fmt/format.h>

#include "machine/bearings/bearing_history.h"
#include "mechanism/structure/tooth_paths.h"
#include "part/verdict.h"

namespace clevis::machine {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kHour = 3600.0;

/// Round-off of forces that equilibrium makes zero, over the largest load.
constexpr double kVanishing = 1e-9;

/// Less than this in a cycle [rad] is round-off of speeds.
bool turns(double travel) {
  constexpr double kLeastTravel = 1e-9;
  return travel > kLeastTravel;
}

double relative_change(double fine, double coarse) {
  return fine > 0.0 ? std::abs(coarse / fine - 1.0) : 0.0;
}

double revolutions(const BearingDefinition& bearing, double mean_load) {
  constexpr double kMillion = 1e6;
  return kMillion * std::pow(bearing.dynamic_rating / mean_load,
                             life_exponent(bearing.kind));
}

/// What speed times time misses of the angle from instant to instant, in all:
/// more than round-off where the joint turns back, or on, between two [rad].
double missed_turn(std::span<const BearingInstant> history) {
  double missed = 0.0;
  for (std::size_t i = 1; i < history.size(); ++i) {
    const BearingInstant &from = history[i - 1], &to = history[i];
    if (!from.angle || !to.angle) continue;
    const double by_speed = 0.5 * (from.speed + to.speed) * (to.t - from.t);
    missed +=
        std::abs(std::remainder(*to.angle - *from.angle - by_speed, kTurn));
  }
  return missed;
}

/// Between the extremes of the angle that the speed integrates to.
double swing(std::span<const BearingInstant> history) {
  double angle = 0.0, least = 0.0, most = 0.0;
  for (std::size_t i = 1; i < history.size(); ++i) {
    angle += 0.5 * (history[i].speed + history[i - 1].speed) *
             (history[i].t - history[i - 1].t);
    least = std::min(least, angle);
    most = std::max(most, angle);
  }
  return most - least;
}

void take_peaks(const BearingDefinition& bearing,
                std::span<const BearingInstant> history,
                BearingResult& result) {
  for (const BearingInstant& here : history) {
    result.peak_radial = std::max(result.peak_radial, here.radial);
    result.peak_axial = std::max(result.peak_axial, here.axial);
    result.peak_tilt = std::max(result.peak_tilt, here.tilt);
    result.peak_load = std::max(
        result.peak_load, dynamic_equivalent(bearing, here.radial, here.axial));
    const double P0 = static_equivalent(bearing, here.radial, here.axial);
    if (P0 > result.static_load) {
      result.static_load = P0;
      result.static_load_at = here.t;
    }
  }
  if (result.static_load > 0.0) {
    result.static_safety = bearing.static_rating / result.static_load;
  }
}

void take_life(const BearingDefinition& bearing,
               std::span<const BearingInstant> history, BearingResult& result) {
  const TravelMean fine = travel_mean(bearing, history);
  const TravelMean coarse = travel_mean(bearing, history, 2);
  result.duration = history.back().t - history.front().t;
  result.travel = fine.travel;
  result.swing = swing(history);
  result.mean_speed = fine.travel / result.duration;
  result.mean_load = fine.mean;
  result.travel_error = relative_change(fine.travel, coarse.travel);
  if (turns(fine.travel)) {
    result.travel_error =
        std::max(result.travel_error, missed_turn(history) / fine.travel);
  }
  result.mean_load_error = relative_change(fine.mean, coarse.mean);
  if (!turns(fine.travel) || !(fine.mean > 0.0)) return;
  const double life = revolutions(bearing, fine.mean);
  if (coarse.mean > 0.0) {
    result.life_error =
        relative_change(life, revolutions(bearing, coarse.mean));
  }
  result.life = life;
  result.life_cycles = life / (fine.travel / kTurn);
  result.life_seconds = *result.life_cycles * result.duration;
}

/// Loads that the equivalent loads do not see, and loads beyond their range.
void warn(const BearingDefinition& bearing,
          std::span<const BearingInstant> history, BearingResult& result) {
  const auto add = [&result](const char* code, std::string text) {
    result.warnings.push_back({code, std::move(text)});
  };
  const double load = std::max(result.peak_radial, result.peak_axial);
  if (result.static_load > bearing.static_rating) {
    add("B001", fmt::format("P0 = {:.6g} N at {:.6g} s is above C0 = {:.6g} N",
                            result.static_load, result.static_load_at,
                            bearing.static_rating));
  }
  if (result.peak_axial > kVanishing * load && !bearing.dynamic_factors) {
    add("B002", fmt::format("axial load up to {:.6g} N, but no factors X and "
                            "Y: left out of the life",
                            result.peak_axial));
  }
  if (result.peak_axial > kVanishing * load && !bearing.static_factors) {
    add("B002", fmt::format("axial load up to {:.6g} N, but no factors X0 and "
                            "Y0: left out of P0",
                            result.peak_axial));
  }
  if (!turns(result.travel)) {
    add("B003", "the joint does not turn: no life, the static check alone");
  }
  const double range =
      std::min(bearing.static_rating, 0.5 * bearing.dynamic_rating);
  if (result.life && result.peak_load > range) {
    add("B004", fmt::format("P = {:.6g} N is above {:.6g} N, the lesser of C0 "
                            "and C/2: ISO 281 leaves the life there to the "
                            "maker",
                            result.peak_load, range));
  }
  // Needle bearings have 0.6, thrust bearings 0.3, others 1 to 3.
  constexpr double kLeastRatio = 0.1, kMostRatio = 10.0;
  const double ratio = bearing.dynamic_rating / bearing.static_rating;
  if (ratio < kLeastRatio || ratio > kMostRatio) {
    add("B009",
        fmt::format("C = {:.6g} N is {:.3g} times C0 = {:.6g} N, as of "
                    "no bearing: see that the units of both are right",
                    bearing.dynamic_rating, ratio, bearing.static_rating));
  }
  constexpr double kFollowed = 0.05;
  if (turns(result.travel) && result.travel_error > kFollowed) {
    add("B008",
        fmt::format("speed times time misses {:.3g} % of the way that "
                    "the joint turns: it is not followed between instants. "
                    "Give more `instants`",
                    100.0 * result.travel_error));
  }
  const double offset = load > 0.0 ? result.peak_tilt / load : 0.0;
  if (offset > 0.5 * bearing.width && offset > kVanishing) {
    add("B005", fmt::format("moment up to {:.6g} N m across the axis, as if "
                            "the load acted {:.4g} mm beside the bearing: not "
                            "in P",
                            result.peak_tilt, 1e3 * offset));
  }
  if (!std::ranges::all_of(history, &BearingInstant::unique)) {
    add("B006",
        "equilibrium leaves the joint's force open: the joints' compliance "
        "shares it");
  }
}

bool warned(const BearingResult& result, const char* code) {
  return std::ranges::any_of(result.warnings, [code](const auto& warning) {
    return warning.code == code;
  });
}

/// Fails by what is certain first; then what the formulas do not cover leaves
/// it open.
void decide(BearingResult& result) {
  if (result.static_safety &&
      *result.static_safety < result.static_safety_wanted) {
    result.verdict = part::Verdict::kFail;
    result.why =
        fmt::format("static safety C0/P0 = {:.4g} < {:.4g}",
                    *result.static_safety, result.static_safety_wanted);
    return;
  }
  const bool is_followed = !warned(result, "B008");
  const bool life_fails = result.life_wanted && result.life_seconds &&
                          is_followed &&
                          *result.life_seconds < *result.life_wanted;
  if (life_fails) {
    result.verdict = part::Verdict::kFail;
    result.why =
        fmt::format("life {:.4g} h < {:.4g} h", *result.life_seconds / kHour,
                    *result.life_wanted / kHour);
    return;
  }
  result.verdict = part::Verdict::kNotJudged;
  if (warned(result, "B009")) {
    result.why = "ratings that do not fit one another (B009)";
  } else if (warned(result, "B002")) {
    result.why = "axial load without its factors (B002)";
  } else if (warned(result, "B005")) {
    result.why = "moment across the axis (B005)";
  } else if (warned(result, "B007")) {
    result.why = "force of teeth left out (B007)";
  } else if (result.life_wanted && !is_followed) {
    result.why = "turning not followed from instant to instant (B008)";
  } else if (result.life_wanted && warned(result, "B004")) {
    result.why = "load beyond the range of the life formula (B004)";
  } else {
    result.verdict = part::Verdict::kPass;
  }
}

}  // namespace

TravelMean travel_mean(const BearingDefinition& bearing,
                       std::span<const BearingInstant> history,
                       std::size_t every) {
  const double p = life_exponent(bearing.kind);
  const auto damage = [&](const BearingInstant& here) {
    // over C, so that the power stays in range
    const double P = dynamic_equivalent(bearing, here.radial, here.axial);
    return std::pow(P / bearing.dynamic_rating, p) * std::abs(here.speed);
  };
  TravelMean sum;
  double worn = 0.0;
  for (std::size_t i = 0; i + 1 < history.size();) {
    const std::size_t next = std::min(i + every, history.size() - 1);
    const BearingInstant &from = history[i], &to = history[next];
    const double half = 0.5 * (to.t - from.t);
    sum.travel += half * (std::abs(from.speed) + std::abs(to.speed));
    worn += half * (damage(from) + damage(to));
    i = next;
  }
  if (sum.travel > 0.0) {
    sum.mean = bearing.dynamic_rating * std::pow(worn / sum.travel, 1.0 / p);
  }
  return sum;
}

BearingResult judge_bearing(const BearingDefinition& bearing,
                            std::span<const BearingInstant> history,
                            bool geared) {
  BearingResult result;
  result.name = bearing.name;
  result.joint = bearing.joint;
  result.kind = bearing.kind;
  result.dynamic_rating = bearing.dynamic_rating;
  result.static_rating = bearing.static_rating;
  result.static_safety_wanted = bearing.static_safety_wanted;
  result.life_wanted = bearing.life_wanted;
  take_peaks(bearing, history, result);
  take_life(bearing, history, result);
  warn(bearing, history, result);
  if (geared) {
    result.warnings.push_back(
        {"B007",
         "teeth of a gear or rack load the joint, and their force is not in "
         "the load"});
  }
  decide(result);
  return result;
}

std::vector<BearingResult> judge_bearings(
    const std::vector<BearingDefinition>& bearings,
    const mechanism::MechanismDefinition& mechanism,
    const mechanism::Motion& motion) {
  std::vector<BearingResult> results;
  for (const BearingDefinition& bearing : bearings) {
    const auto lacks_teeth = [&](std::size_t coupling) {
      return std::ranges::binary_search(
          mechanism::joints_without_teeth(mechanism, motion, coupling),
          static_cast<std::size_t>(bearing.joint));
    };
    bool geared = false;
    for (std::size_t k = 0; k < mechanism.couplings.size(); ++k) {
      geared = geared || lacks_teeth(k);
    }
    results.push_back(judge_bearing(
        bearing, bearing_history(bearing, mechanism, motion), geared));
  }
  return results;
}

}  // namespace clevis::machine
