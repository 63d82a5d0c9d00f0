#include "loads/holds/holding_groups.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "base/algebra/singular_vectors.h"
#include "base/values/round_off_length.h"
#include "loads/seats/force_seats.h"

namespace clevis::loads {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;

constexpr Index kWrench = 6;
constexpr char kOwn = '\n';  // before a holder's own name, in no group's
// Of a unit wrench: what is held at so small an angle gives way as a whole.
constexpr double kHolds = 0.1;
constexpr double kRoundOff = 1e-9;

/// Each two of some groups; fewer than two: those.
std::vector<HoldingGroups> pairs_of(const HoldingGroups& groups) {
  if (groups.size() < 2) return {groups};
  std::vector<HoldingGroups> pairs;
  for (std::size_t a = 0; a < groups.size(); ++a) {
    for (std::size_t b = a + 1; b < groups.size(); ++b) {
      pairs.push_back({groups[a], groups[b]});
    }
  }
  return pairs;
}

HoldingGroups bearing_groups(const LoadHistory& history) {
  HoldingGroups groups;
  for (const Seat& seat : history.seats) {
    if (seat.kind == SeatKind::kBearing && !is_force_seat(seat) &&
        std::ranges::find(groups, seat.group) == groups.end()) {
      groups.push_back(seat.group);
    }
  }
  return groups;
}

/// Largest distance between seats [m].
double size_of(const std::vector<Seat>& seats) {
  constexpr double kOfOne = 0.01;  // whatever it is
  double size = 0.0;
  for (const Seat& one : seats) {
    for (const Seat& other : seats) {
      size = std::max(size, (one.p_LS - other.p_LS).norm());
    }
  }
  return size > kRoundOffLength ? size : kOfOne;
}

/// Wrenches by holder, about the first of its seats.
/// @param wrenches  of SeatHold; moments over a size.
/// @param size  [m].
std::vector<GroupHold> by_holder(const std::vector<Seat>& seats,
                                 const MatrixXd& wrenches, double size) {
  std::vector<GroupHold> holds;
  for (std::size_t s = 0; s < seats.size(); ++s) {
    const Seat& seat = seats[s];
    const std::string holder = holder_of(seats, s);
    auto hold = std::ranges::find(holds, holder, &GroupHold::group);
    if (hold == holds.end()) {
      holds.push_back(
          {holder, seat.p_LS, MatrixXd::Zero(kWrench, wrenches.cols())});
      hold = std::prev(holds.end());
    }
    const MatrixXd here =
        wrenches.middleRows<kWrench>(kWrench * static_cast<Index>(s));
    hold->wrenches += here;
    const Vector3d arm = (seat.p_LS - hold->p_LS) / size;
    for (Index k = 0; k < here.cols(); ++k) {
      const Vector3d force = here.col(k).head<3>();
      hold->wrenches.col(k).tail<3>() += arm.cross(force);
    }
  }
  return holds;
}

/// What does not give way; moments over the size [N].
std::vector<GroupHold> holds_of(const std::vector<Seat>& seats, MatrixXd held) {
  const double size = size_of(seats);
  for (Index row = 0; row < held.rows(); ++row) {
    if (row % kWrench >= 3) held.row(row) /= size;
  }
  return by_holder(seats, column_space(held, kRoundOff), size);
}

/// The same with moments as they are [N m].
std::vector<GroupHold> held_groups(const std::vector<Seat>& seats,
                                   MatrixXd wrenches) {
  auto held = holds_of(seats, std::move(wrenches));
  const double size = size_of(seats);
  for (GroupHold& hold : held) hold.wrenches.bottomRows<3>() *= size;
  return held;
}

/// Where the groups' mean motions are: of a slide in the middle of what it
/// touches, which its seat's point may be far from. By group, in L [m].
std::vector<Vector3d> middles_of(const std::vector<GroupHold>& held,
                                 const std::vector<Seat>& seats,
                                 const std::vector<ContactZone>& zones) {
  std::vector<Vector3d> middles;
  for (const GroupHold& hold : held) {
    Vector3d& middle = middles.emplace_back(hold.p_LS);
    for (std::size_t s = 0; s < std::min(seats.size(), zones.size()); ++s) {
      if (holder_of(seats, s) != hold.group) continue;
      const double along = 0.5 * (zones[s].low[0] + zones[s].high[0]);
      if (seats[s].slide && std::isfinite(along)) {
        middle += along * seats[s].slide->along_L;
      }
      break;
    }
  }
  return middles;
}

/// Of force elements at the part's own seats.
const MatrixXd& sprung_of(const SeatHold& hold) {
  return hold.swinging ? hold.swinging->sprung : hold.sprung;
}

/// Of springs those that act on the part alone: what others hold of it, they
/// hold of the mechanism's motion.
MatrixXd own_springs(const std::vector<Seat>& seats, const MatrixXd& sprung) {
  std::vector<Index> own;
  for (Index k = 0; k < sprung.cols(); ++k) {
    double elsewhere = 0.0;
    for (std::size_t s = 0; s < seats.size(); ++s) {
      if (is_force_seat(seats[s])) continue;
      const auto here =
          sprung.col(k).segment<kWrench>(kWrench * static_cast<Index>(s));
      elsewhere = std::max(elsewhere, here.norm());
    }
    const double all = sprung.col(k).norm();
    if (all > 0.0 && elsewhere <= kRoundOff * all) own.push_back(k);
  }
  return sprung(Eigen::all, own);
}

/// What is held of all groups, moments over the part's size.
class HeldSpan {
 public:
  explicit HeldSpan(const std::vector<GroupHold>& held) : held_(held) {
    std::vector<Seat> places;
    for (const GroupHold& hold : held) places.push_back({.p_LS = hold.p_LS});
    size_ = size_of(places);
    MatrixXd all(kWrench * std::ssize(held), held.front().wrenches.cols());
    for (std::size_t g = 0; g < held.size(); ++g) {
      all.middleRows<kWrench>(kWrench * static_cast<Index>(g)) =
          held[g].wrenches;
      all.middleRows<3>(kWrench * static_cast<Index>(g) + 3) /= size_;
    }
    span_ = column_space(all, kRoundOff);
  }

  bool is_like(const HeldSpan& other) const {
    constexpr double kLike = 1e-4;
    return span_.cols() == other.span_.cols() &&
           (other.span_ - span_ * (span_.transpose() * other.span_)).norm() <
               kLike;
  }

  /// More columns than forces and moments on the whole part.
  bool is_redundant() const {
    constexpr double kFelt = 1e-6;
    MatrixXd net = MatrixXd::Zero(kWrench, span_.cols());
    for (std::size_t g = 0; g < held_.size(); ++g) {
      const MatrixXd here =
          span_.middleRows<kWrench>(kWrench * static_cast<Index>(g));
      const Vector3d arm = (held_[g].p_LS - held_.front().p_LS) / size_;
      net += here;
      for (Index k = 0; k < here.cols(); ++k) {
        const Vector3d force = here.col(k).head<3>();
        net.col(k).tail<3>() += arm.cross(force);
      }
    }
    if (net.cols() == 0) return false;
    return singular_vectors(net).rank(kFelt) < net.cols();
  }

  /// Groups in the order in which all that they stand for is held; empty: it is
  /// not in any.
  /// @param middles  where each has its mean motion [m].
  HoldingGroups order_of(const HoldingGroups& groups,
                         const std::vector<Vector3d>& middles) const {
    const auto force = [&](Index group, const Vector3d& direction) {
      Eigen::VectorXd wrench = unit(group, true, direction);
      const auto at = static_cast<std::size_t>(group);
      wrench.segment<3>(kWrench * group + 3) =
          (middles[at] - held_[at].p_LS).cross(direction) / size_;
      return wrench;
    };
    const Index first = index_of(groups.front());
    if (groups.size() == 1) {
      for (Index k = 0; k < kWrench; ++k) {
        if (!holds(span_, unit(first, k < 3, Vector3d::Unit(k % 3)))) {
          return {};
        }
      }
      return groups;
    }
    const Index second = index_of(groups.back());
    const Vector3d line = middles[static_cast<std::size_t>(second)] -
                          middles[static_cast<std::size_t>(first)];
    if (!(line.norm() > kRoundOffLength)) return {};
    const Vector3d along = line.normalized();
    const Vector3d across = along.unitOrthogonal();
    // What is held along the line bends nothing.
    MatrixXd all(span_.rows(), span_.cols() + 2);
    all << span_, force(first, along), force(second, along);
    const MatrixXd span = column_space(all, kRoundOff);
    for (const Index group : {first, second}) {
      if (!holds(span, force(group, across)) ||
          !holds(span, force(group, along.cross(across)))) {
        return {};
      }
    }
    if (holds(span, unit(first, false, along))) return groups;
    if (holds(span, unit(second, false, along))) {
      return {groups.back(), groups.front()};
    }
    return {};
  }

 private:
  Index index_of(const std::string& group) const {
    return std::ranges::find(held_, group, &GroupHold::group) - held_.begin();
  }
  /// A force or a moment on a group.
  Eigen::VectorXd unit(Index group, bool is_force,
                       const Vector3d& direction) const {
    Eigen::VectorXd wrench = Eigen::VectorXd::Zero(span_.rows());
    wrench.segment<3>(kWrench * group + (is_force ? 0 : 3)) = direction;
    return wrench;
  }
  static bool holds(const MatrixXd& span, const Eigen::VectorXd& wrench) {
    constexpr double kMixed = 1e-6;  // with what others hold
    return (wrench - span * (span.transpose() * wrench)).norm() < kMixed;
  }

  const std::vector<GroupHold>& held_;
  double size_{};
  MatrixXd span_;
};

/// Of groups that are not empty.
PartHold hold_of(const std::vector<Seat>& seats, const SeatHold& hold,
                 const HoldingGroups& groups) {
  auto held = held_groups(seats, hold.held);
  auto order =
      HeldSpan(held).order_of(groups, middles_of(held, seats, hold.zones));
  if (!order.empty()) return {std::move(order)};
  return {groups, std::move(held)};
}

/// Whether rows of wrenches are held, each direction of them.
bool holds_all(const MatrixXd& rows) {
  if (rows.cols() < rows.rows()) return false;
  return singular_values(rows).minCoeff() > kHolds;
}

bool holds_across(const GroupHold& hold, const Vector3d& line) {
  Eigen::Matrix<double, 2, 3> across;
  across.row(0) = line.unitOrthogonal();
  across.row(1) = line.cross(line.unitOrthogonal()).normalized();
  return holds_all(across * hold.wrenches.topRows<3>());
}

bool holds_place(const GroupHold& hold) {
  return hold.wrenches.topRows<3>().norm() > kHolds;
}

/// A group's wrenches with what others hold that bends nothing between: moments
/// of those that hold nothing else, as the face of a drive that turns the part
/// at a pin, and forces along the line to them, as of a drive along a slide.
MatrixXd with_rest_of_others(const GroupHold& hold,
                             const std::vector<GroupHold>& all) {
  MatrixXd wrenches = hold.wrenches;
  for (const GroupHold& other : all) {
    if (other.group == hold.group) continue;
    if (!holds_place(other)) {
      wrenches.bottomRows<3>() += other.wrenches.bottomRows<3>();
      continue;
    }
    const Vector3d along = (other.p_LS - hold.p_LS).normalized();
    wrenches.topRows<3>() +=
        along * (along.transpose() * other.wrenches.topRows<3>());
  }
  return wrenches;
}

}  // namespace

std::string holder_of(const std::vector<Seat>& seats, std::size_t seat) {
  const Seat& here = seats[seat];
  const auto sharing = std::ranges::count(seats, here.group, &Seat::group);
  return here.slide && sharing > 1 ? here.group + kOwn + here.name : here.group;
}

std::string group_of(const std::string& holder) {
  return holder.substr(0, holder.find(kOwn));
}

std::vector<GroupHold> held_groups(const LoadHistory& history, double time) {
  return held_groups(history.seats, history.hold(time).held);
}

PartHold hold_at(const LoadHistory& history, const HoldingGroups& groups,
                 double time) {
  if (!history.hold || groups.empty()) return {groups};
  return hold_of(history.seats, history.hold(time), groups);
}

PartHold reference_at(const LoadHistory& history, const HoldingGroups& groups,
                      double time) {
  if (!history.hold || groups.empty()) return {groups};
  const SeatHold hold = history.hold(time);
  PartHold found = hold_of(history.seats, hold, groups);
  if (found.held.empty()) return found;  // the groups hold all
  const MatrixXd sprung = own_springs(history.seats, sprung_of(hold));
  if (sprung.cols() > 0) found.sprung = by_holder(history.seats, sprung, 1.0);
  return found;
}

bool are_alike(const PartHold& one, const PartHold& other) {
  constexpr double kLike = 1e-4;
  if (one.groups != other.groups || !are_alike(one.held, other.held) ||
      one.sprung.size() != other.sprung.size()) {
    return false;
  }
  for (std::size_t a = 0; a < one.sprung.size(); ++a) {
    for (std::size_t b = 0; b < one.sprung.size(); ++b) {
      const auto stiffness = [&](const PartHold& hold) -> MatrixXd {
        return hold.sprung[a].wrenches * hold.sprung[b].wrenches.transpose();
      };
      const MatrixXd here = stiffness(one);
      if ((here - stiffness(other)).norm() > kLike * here.norm()) return false;
    }
  }
  return true;
}

bool are_alike(const std::vector<GroupHold>& one,
               const std::vector<GroupHold>& other) {
  if (one.size() != other.size()) return false;
  return one.empty() || HeldSpan(one).is_like(HeldSpan(other));
}

bool is_redundant(const std::vector<GroupHold>& held) {
  return !held.empty() && HeldSpan(held).is_redundant();
}

std::vector<HoldingGroups> holding_groups(const LoadHistory& history) {
  if (!history.hold) return pairs_of(bearing_groups(history));
  constexpr double kNearest = 1e-3;  // of the size: no line between them
  const SeatHold hold = history.hold(history.hold_time);
  std::vector<GroupHold> holds = holds_of(history.seats, hold.held);
  std::ranges::sort(holds, {}, &GroupHold::group);
  const auto middles = middles_of(holds, history.seats, hold.zones);
  const double size = size_of(history.seats);
  std::vector<HoldingGroups> found;
  for (std::size_t one = 0; one < holds.size(); ++one) {
    for (std::size_t other = one + 1; other < holds.size(); ++other) {
      const Vector3d line = middles[other] - middles[one];
      if (line.norm() > kNearest * size && holds_across(holds[one], line) &&
          holds_across(holds[other], line)) {
        found.push_back({holds[one].group, holds[other].group});
      }
    }
  }
  if (!found.empty()) return found;
  HoldingGroups some;
  for (const GroupHold& one : holds) {
    if (!holds_place(one)) continue;
    some.push_back(one.group);
    if (holds_all(with_rest_of_others(one, holds))) {
      found.push_back({one.group});
    }
  }
  return found.empty() ? pairs_of(some) : found;
}

HoldingGroups reference_groups(const LoadHistory& history) {
  HoldingGroups held = holding_groups(history).front();
  if (!held.empty() || !history.hold) return held;
  const SeatHold hold = history.hold(history.hold_time);
  const MatrixXd& sprung = sprung_of(hold);
  std::vector<std::size_t> yielding;
  for (std::size_t s = 0; s < history.seats.size(); ++s) {
    const Index row = kWrench * static_cast<Index>(s);
    if (row + kWrench <= sprung.rows() &&
        !sprung.middleRows<kWrench>(row).isZero(0.0)) {
      yielding.push_back(s);
    }
  }
  if (yielding.empty()) return held;
  const auto away = [&](std::size_t s) {
    return (history.seats[s].p_LS - history.seats[yielding.front()].p_LS)
        .norm();
  };
  const std::size_t farthest = std::ranges::max(yielding, {}, away);
  held.push_back(holder_of(history.seats, yielding.front()));
  const std::string other = holder_of(history.seats, farthest);
  if (away(farthest) > kRoundOffLength && other != held.front()) {
    held.push_back(other);
  }
  return held;
}

}  // namespace clevis::loads
