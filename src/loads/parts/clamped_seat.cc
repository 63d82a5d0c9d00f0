#include "loads/parts/clamped_seat.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "loads/history/balance.h"
#include "loads/holds/holding_groups.h"
#include "loads/holds/seat_hold.h"
#include "loads/seats/force_seats.h"

namespace clevis::loads {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;

constexpr Index kWrench = 6;

/// Largest moment of all that a seat's group takes, of a bore about its axis
/// [N m].
double largest_moment(const LoadHistory& history, std::size_t index,
                      const GroupGeometry& group) {
  const Seat& seat = history.seats[index];
  const bool is_bore = seat.kind == SeatKind::kBearing;
  double largest = 0.0;
  for (const InstantLoad& instant : history.instants) {
    Vector3d moment = Vector3d::Zero();
    for (std::size_t s = 0; s < history.seats.size(); ++s) {
      if (history.seats[s].group != seat.group) continue;
      const Wrench& wrench = instant.wrenches[s];
      moment +=
          about(wrench.force, wrench.moment, history.seats[s].p_LS, seat.p_LS)
              .moment;
    }
    largest =
        std::max(largest, is_bore ? std::abs(moment.dot(group.cylinder.axis_L))
                                  : moment.norm());
  }
  return largest;
}

double largest_force(const LoadHistory& history, const std::string& group) {
  double largest = 0.0;
  for (const InstantLoad& instant : history.instants) {
    Vector3d force = Vector3d::Zero();
    for (std::size_t s = 0; s < history.seats.size(); ++s) {
      if (history.seats[s].group == group) force += instant.wrenches[s].force;
    }
    largest = std::max(largest, force.norm());
  }
  return largest;
}

/// One seat of each group but those of forces, which hold nothing; of a bore
/// one that bears.
std::vector<std::size_t> seats_of_groups(const LoadHistory& history) {
  std::vector<std::size_t> found;
  for (std::size_t s = 0; s < history.seats.size(); ++s) {
    const Seat& seat = history.seats[s];
    if (is_force_seat(seat)) continue;
    const auto same = std::ranges::find_if(found, [&](std::size_t other) {
      return history.seats[other].group == seat.group;
    });
    if (same == found.end()) {
      found.push_back(s);
    } else if (seat.kind == SeatKind::kBearing) {
      *same = s;
    }
  }
  return found;
}

/// Whether a bore takes loads of a face, too, as that of a drive.
bool is_driven(const LoadHistory& history, const std::string& bore) {
  return std::ranges::any_of(history.seats, [&bore](const Seat& seat) {
    return seat.group == bore && seat.kind != SeatKind::kBearing &&
           !is_force_seat(seat);
  });
}

std::optional<std::size_t> clamped_seat(
    const std::vector<GroupGeometry>& groups, double size,
    const LoadHistory& history) {
  // Of forces × size: moments at least, at most those of friction. A face that
  // takes one beside fewer than two pins has nothing else to hold it.
  constexpr double kHolds = 0.1, kFriction = 0.03, kRoundOff = 1e-6;
  const std::vector<std::size_t> seats = seats_of_groups(history);
  double force = 0.0;
  for (const std::size_t s : seats) {
    force = std::max(force, largest_force(history, history.seats[s].group));
  }
  if (!(force > 0.0)) return std::nullopt;
  const bool has_pins =
      std::ranges::count(seats, SeatKind::kBearing, [&history](std::size_t s) {
        return history.seats[s].kind;
      }) > 1;
  std::optional<std::size_t> clamped;
  for (const std::size_t s : seats) {
    const Seat& seat = history.seats[s];
    const auto group =
        std::ranges::find(groups, seat.group, &GroupGeometry::name);
    const double moment = largest_moment(history, s, *group) / (force * size);
    const bool is_bore = seat.kind == SeatKind::kBearing;
    const bool is_sure = is_bore && is_driven(history, seat.group);
    const bool is_face = !is_bore && !has_pins;
    if (!is_sure && moment <= (is_face ? kRoundOff : kFriction)) continue;
    if (clamped || (!is_sure && !is_face && moment <= kHolds)) {
      return std::nullopt;
    }
    clamped = s;
  }
  // What takes no force turns the part, and others hold it.
  if (clamped && largest_force(history, history.seats[*clamped].group) <=
                     kFriction * force) {
    return std::nullopt;
  }
  return clamped;
}

}  // namespace

void hold_clamped_seat(const std::vector<GroupGeometry>& groups, double size,
                       LoadHistory& history) {
  const auto seat = clamped_seat(groups, size, history);
  if (!seat) {
    const HoldingGroups pins = holding_groups(history).front();
    history.notes.push_back(fmt::format(
        "what holds the part is not in its loads: its deflection is relative "
        "to {} and it vibrates as a free part. If one end is clamped, `fixed` "
        "or a `foundation` there says so, of pins that hold it `held_by_pin`",
        pins.empty()
            ? "its own mean motion"
            : fmt::format(
                  "{}, {} it buckles,", fmt::join(pins, " and "),
                  pins.size() == 1 ? "clamped at which" : "between which")));
    return;
  }
  const Index rows = kWrench * std::ssize(history.seats);
  SeatHold hold;
  hold.weighed = hold.sprung = hold.damped = MatrixXd(rows, 0);
  hold.held = MatrixXd::Zero(rows, kWrench);
  hold.held.middleRows<kWrench>(kWrench * static_cast<Index>(*seat))
      .setIdentity();
  history.hold_time = history.instants[hardest_instant(history.instants)].time;
  history.hold = [hold = std::move(hold)](double time) {
    SeatHold now = hold;
    now.time = time;
    return now;
  };
  const std::string& group = history.seats[*seat].group;
  history.notes.push_back(fmt::format(
      "{} counts as what alone holds the part, for it takes a moment or the "
      "loads of a drive: deflection is relative to it",
      group));
}

}  // namespace clevis::loads
