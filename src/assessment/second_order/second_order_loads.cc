#include "assessment/second_order/second_order_loads.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "assessment/buckling/buckling_check.h"
#include "assessment/pace/load_pace.h"
#include "loads/history/motion_instants.h"
#include "loads/history/turning_loads.h"

namespace clevis::assessment {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using loads::InstantLoad;

double pressed(const PartResult& result, const Swing& swing) {
  if (!result.buckling.factor) return 0.0;
  const double share = swing.largest() / result.buckling.band_low;
  return share * kFirstOrderIsEnough > 1.0 ? share : 0.0;
}

/// Keeps what others between two points are off their straight line.
/// @param kept  by point.
void keep_bends(const std::vector<LoadPoint>& points, std::size_t from,
                std::size_t to, std::vector<bool>& kept) {
  constexpr double kOff = 3e-3;
  const auto size = [&](auto member) {
    return std::max((points[from].*member).norm(), (points[to].*member).norm());
  };
  const double load = size(&LoadPoint::amounts);
  const double spin = size(&LoadPoint::omega);
  double farthest = kOff;
  std::size_t bend = to;
  for (std::size_t i = from + 1; i < to; ++i) {
    const LoadPoint line = between(points[from], points[to],
                                   (points[i].time - points[from].time) /
                                       (points[to].time - points[from].time));
    const double off = std::max(
        (points[i].amounts - line.amounts).norm() / load,
        spin > 0.0 ? (points[i].omega - line.omega).norm() / spin : 0.0);
    if (off <= farthest) continue;
    farthest = off;
    bend = i;
  }
  if (bend == to) return;
  kept[bend] = true;
  keep_bends(points, from, bend, kept);
  keep_bends(points, bend, to, kept);
}

}  // namespace

std::vector<bool> bent_by_pins(const std::vector<loads::Seat>& seats,
                               const SecondOrderLoads& loads,
                               const std::vector<std::string>& holders,
                               double size) {
  constexpr double kBends = 1e-3;  // of the largest force at the part's size
  std::vector<bool> bent;
  for (const auto& instant : loads.instants) {
    double force = 0.0, moment = 0.0;
    for (std::size_t s = 0; s < seats.size(); ++s) {
      const loads::Wrench& wrench = instant.wrenches[s];
      force = std::max(force, wrench.force.norm());
      if (seats[s].kind == loads::SeatKind::kBearing && !seats[s].slide &&
          std::ranges::find(holders, loads::holder_of(seats, s)) !=
              holders.end()) {
        moment = std::max(moment, wrench.moment.norm());
      }
    }
    bent.push_back(moment > kBends * force * size);
  }
  return bent;
}

Swing swing_of(const PartResult& result, std::size_t set) {
  return result.swings.empty() ? Swing{} : result.swings[set];
}

SecondOrderLoads second_order_loads(const PartJob& job, std::size_t s,
                                    const PartResult& result) {
  const LoadSet& set = job.load_sets[s];
  const std::size_t motion = loads::motion_length(set.history);
  const double slow =
      kSlowSpin * 2.0 * std::numbers::pi / softest_period(job, set);
  SecondOrderLoads looked;
  looked.set = s;
  looked.pressed = pressed(result, swing_of(result, s));
  const auto& all = set.history.instants;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool may_be_fast = all[i].rigid.omega.norm() > slow;
    looked.may_be_fast |= may_be_fast;
    if (looked.pressed == 0.0 && !may_be_fast) continue;
    looked.instants.push_back(all[i]);
    looked.index.push_back(i);
    if (motion > 1 && i < motion) looked.motion = looked.instants.size();
  }
  return looked;
}

bool LoadPoint::is_like(const LoadPoint& other, double share) const {
  return is_motion == other.is_motion &&
         (omega - other.omega).norm() <= share * omega.norm() &&
         (amounts - other.amounts).norm() <= share * amounts.norm();
}

LoadPoint between(const LoadPoint& from, const LoadPoint& to, double share) {
  LoadPoint point = from;
  point.label = fmt::format("between {} and {}", from.label, to.label);
  point.time = from.time + share * (to.time - from.time);
  point.omega = from.omega + share * (to.omega - from.omega);
  point.amounts = from.amounts + share * (to.amounts - from.amounts);
  point.gain = from.gain + share * (to.gain - from.gain);
  return point;
}

std::vector<LoadPoint> load_points(
    const SecondOrderLoads& loads, const MatrixXd& coefficients,
    const std::function<MatrixXd(Index)>& gain,
    const std::function<bool(const InstantLoad&)>& stays) {
  std::vector<LoadPoint> all;
  for (std::size_t i = 0; i < loads.instants.size(); ++i) {
    const InstantLoad& instant = loads.instants[i];
    const bool goes_on =
        i + 1 < loads.motion && loads.index[i + 1] == loads.index[i] + 1;
    all.push_back({instant.label,
                   instant.time,
                   i < loads.motion,
                   goes_on,
                   instant.rigid.omega,
                   coefficients.col(static_cast<Index>(i)),
                   static_cast<Index>(i),
                   {}});
  }
  std::vector<bool> kept(all.size(), true);
  for (std::size_t from = 0; from < all.size();) {
    std::size_t to = from;
    while (all[to].goes_on && all[to + 1].time > all[to].time) ++to;
    for (std::size_t i = from + 1; i < to; ++i) {
      kept[i] = stays(loads.instants[i]);
    }
    if (to > from) keep_bends(all, from, to, kept);
    from = to + 1;
  }
  std::vector<LoadPoint> points;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!kept[i]) continue;
    all[i].gain = gain(all[i].instant);
    points.push_back(std::move(all[i]));
  }
  return points;
}

std::optional<VectorXd> common_load(const SecondOrderLoads& loads,
                                    const MatrixXd& coefficients) {
  constexpr double kSteady = 0.02;
  const auto count = static_cast<Index>(loads.motion);
  if (count < 4) return std::nullopt;
  const auto& instants = loads.instants;
  const Eigen::Vector3d first = instants.front().rigid.omega;
  VectorXd angles(count);
  double turned = 0.0;
  for (Index i = 0; i < count; ++i) {
    const InstantLoad& here = instants[static_cast<std::size_t>(i)];
    const Eigen::Vector3d& omega = here.rigid.omega;
    if ((omega - first).norm() > kSteady * first.norm()) return std::nullopt;
    turned = omega.norm() * (here.time - instants.front().time);
    angles[i] = turned;
  }
  if (turned < std::numbers::pi) return std::nullopt;
  return loads::share_that_turns_with(angles,
                                      coefficients.leftCols(count).transpose());
}

}  // namespace clevis::assessment
