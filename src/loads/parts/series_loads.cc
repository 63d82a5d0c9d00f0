#include "loads/parts/series_loads.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "base/messages/errors.h"
#include "loads/history/balance.h"
#include "loads/holds/seat_hold.h"
#include "loads/parts/clamped_seat.h"
#include "loads/parts/held_pins.h"
#include "loads/parts/surface_loads.h"

namespace clevis::loads {
namespace {

using Eigen::Vector3d;
using part::LoadSeries;
using part::SeriesInstant;

Seat seat_of(const part::SeriesSeat& given,
             const std::vector<GroupGeometry>& groups,
             const std::string& place) {
  const GroupGeometry& group = find_group(groups, given.group, place);
  Seat seat{.name = given.name, .group = given.group};
  if (given.is_face) {
    seat.kind = SeatKind::kTraction;
    seat.p_LS = group.centroid;
    return seat;
  }
  require_cylinder(group, place);
  seat.kind = SeatKind::kBearing;
  seat.p_LS = group.cylinder.p_LC;
  return seat;
}

/// Rows of one time are the sides of steps: a label tells them apart.
/// @param steps  rows before it that have its time.
std::string label_of(const LoadSeries& series, const SeriesInstant& given,
                     int steps) {
  std::string label = fmt::format("{}, t = {:.6g} s", series.name, given.time);
  if (given.is_between_rows) label += " between rows";
  if (steps > 0) label += " after its step";
  if (steps > 1) label += fmt::format(" {}", steps);
  return label;
}

InstantLoad instant_of(const LoadSeries& series, const SeriesInstant& given,
                       const std::vector<Seat>& seats,
                       const std::vector<GroupGeometry>& groups,
                       const std::string& place) {
  InstantLoad instant;
  instant.is_between_rows = given.is_between_rows;
  instant.time = given.time;
  for (std::size_t s = 0; s < seats.size(); ++s) {
    instant.wrenches.push_back(
        about(given.forces[s], given.moments[s],
              series.seats[s].about.value_or(seats[s].p_LS), seats[s].p_LS));
  }
  std::map<std::string, double> pressures;
  for (std::size_t p = 0; p < series.pressurized.size(); ++p) {
    pressures.emplace(series.pressurized[p], given.pressures[p]);
  }
  instant.surface_loads = surface_loads(pressures, {}, groups, place);
  instant.rigid = {.acceleration = given.acceleration,
                   .alpha = given.angular_acceleration,
                   .omega = given.angular_velocity};
  return instant;
}

/// Rests of the balance of a series, over its largest loads. Those of rows
/// count; between two the file tells nothing that could be out of balance.
class SeriesBalance {
 public:
  SeriesBalance(const LoadHistory& history, const part::MassProperties& mass,
                double size) {
    for (const InstantLoad& instant : history.instants) {
      rests_.push_back(imbalance(history, instant, mass, size));
      is_row_.push_back(!instant.is_between_rows);
      force_scale_ = std::max(force_scale_, rests_.back().force_scale);
      moment_scale_ = std::max(moment_scale_, rests_.back().moment_scale);
    }
    for (Imbalance& rest : rests_) {
      rest.force_scale = force_scale_;
      rest.moment_scale = moment_scale_;
    }
  }

  const Imbalance& operator[](std::size_t i) const { return rests_[i]; }
  /// Of the rows.
  std::size_t largest() const {
    std::size_t largest = 0;
    for (std::size_t i = 1; i < rests_.size(); ++i) {
      if (is_row_[i] && rests_[largest].relative() < rests_[i].relative()) {
        largest = i;
      }
    }
    return largest;
  }

 private:
  std::vector<Imbalance> rests_;
  std::vector<bool> is_row_;
  double force_scale_{};
  double moment_scale_{};
};

std::string text_of(const Imbalance& rest) {
  return fmt::format(
      "{:.4g} N and, about the part's origin, {:.4g} N m, "
      "{:.2g} % of the largest sum of all loads",
      rest.left.force.norm(), rest.left.moment.norm(), 100.0 * rest.relative());
}

/// Gives a free part the accelerations that balance its loads.
void balance(const LoadSeries& series, const part::MassProperties& mass,
             double size, const std::string& place, LoadHistory& history) {
  const SeriesBalance rests(history, mass, size);
  const std::size_t worst = rests.largest();
  const std::string& label = history.instants[worst].label;
  // Written so that a NaN is refused, too.
  if (series.has_acceleration &&
      !(rests[worst].relative() <= series.largest_imbalance)) {
    throw Error(
        "L001", place,
        fmt::format("{}: the loads leave {}", label, text_of(rests[worst])),
        fmt::format("Give the missing load or acceleration, its "
                    "`gravity`, or a larger `largest_imbalance` than "
                    "{:.3g} %; hold the part with `fixed` or a "
                    "`foundation` if something holds it.",
                    100.0 * series.largest_imbalance));
  }
  double fastest = 0.0, spun_up = 0.0;
  for (std::size_t i = 0; i < history.instants.size(); ++i) {
    const RigidAcceleration more = relieving_acceleration(rests[i].left, mass);
    RigidAcceleration& rigid = history.instants[i].rigid;
    rigid.acceleration += more.acceleration;
    rigid.alpha += more.alpha;
    history.instants[i].relief = rests[i].left;
    const Vector3d force = inertia_load(rigid, mass).force;
    fastest = std::max(fastest, force.norm() / mass.mass);
    spun_up = std::max(spun_up, rigid.alpha.norm());
  }
  if (series.has_acceleration) {
    history.notes.push_back(fmt::format(
        "history {}: its loads leave at most {}, at t = {:.6g} s: "
        "inertia takes it up",
        series.name, text_of(rests[worst]), history.instants[worst].time));
  } else {
    history.notes.push_back(
        fmt::format("history {}: its file has no accelerations; those that "
                    "balance its loads reach {:.4g} m/s^2 at the centre of "
                    "mass and {:.4g} rad/s^2{}",
                    series.name, fastest, spun_up,
                    fastest > kHardAcceleration
                        ? ": see that signs and units of its loads are right"
                        : ""));
  }
}

/// Way that the line of a seat's force has over the rows that matter, along its
/// bore or on its face [m]; 0: it leaves that, as where moments load it.
double way_of_force(const LoadHistory& history, std::size_t seat,
                    const GroupGeometry& group, double size) {
  constexpr double kCounts = 0.1;  // of its largest force
  constexpr double kWithin = 0.6;  // of the size, from its middle
  double largest = 0.0;
  for (const InstantLoad& instant : history.instants) {
    largest = std::max(largest, instant.wrenches[seat].force.norm());
  }
  Eigen::AlignedBox3d lines;
  for (const InstantLoad& instant : history.instants) {
    const auto& [force, moment] = instant.wrenches[seat];
    if (largest == 0.0 || force.norm() < kCounts * largest) continue;
    Vector3d at = force.cross(moment) / force.squaredNorm();
    if (history.seats[seat].kind == SeatKind::kBearing) {
      at = at.dot(group.cylinder.axis_L) * group.cylinder.axis_L;
    }
    if (at.norm() > kWithin * size) return 0.0;
    lines.extend(at);
  }
  return lines.isEmpty() ? 0.0 : lines.diagonal().norm();
}

double size_of(const GroupGeometry& group) {
  if (group.is_cylinder) return group.cylinder.length;
  Eigen::AlignedBox3d face;
  for (const Vector3d& point : group.points.colwise()) face.extend(point);
  return face.isEmpty() ? std::sqrt(group.area) : face.diagonal().norm();
}

/// Tells forces that travel on what they are spread over, as those of slides: a
/// file says where their resultants act, not on how much of a face.
void note_travelling(const LoadSeries& series,
                     const std::vector<GroupGeometry>& groups,
                     const std::string& place, LoadHistory& history) {
  constexpr double kTravels = 0.2;
  for (std::size_t s = 0; s < history.seats.size(); ++s) {
    const Seat& seat = history.seats[s];
    const GroupGeometry& group = find_group(groups, seat.group, place);
    const double size = size_of(group);
    const double way = way_of_force(history, s, group, size);
    if (way < kTravels * size) continue;
    history.notes.push_back(fmt::format(
        "history {}: the force \"{}\" travels by {:.3g} mm on \"{}\" ({:.3g} "
        "mm). It is spread over all of that, where it may stress the part far "
        "less than where it stands: check the mechanism itself, whose slides "
        "have a length, or cases with a group where it stands",
        series.name, seat.name, way * 1e3, seat.group, size * 1e3));
  }
}

}  // namespace

LoadHistory series_loads(const part::PartDefinition& part,
                         const LoadSeries& series,
                         const std::vector<GroupGeometry>& groups,
                         const part::MassProperties& mass) {
  const std::string place = fmt::format("{}: part {}, history {}", series.place,
                                        part.name, series.name);
  LoadHistory history;
  history.rows = series.between;
  for (const part::SeriesSeat& seat : series.seats) {
    history.seats.push_back(seat_of(seat, groups, place));
  }
  int steps = 0;
  for (const SeriesInstant& given : series.instants) {
    const auto& before = history.instants;
    steps = !before.empty() && before.back().time == given.time ? steps + 1 : 0;
    InstantLoad instant =
        instant_of(series, given, history.seats, groups, place);
    instant.label = label_of(series, given, steps);
    history.instants.push_back(std::move(instant));
  }
  note_travelling(series, groups, place, history);
  for (const auto& [name, components] : series.fixed) {
    find_group(groups, name, place);
  }
  for (const auto& [name, foundation] : series.foundations) {
    find_group(groups, name, place);
  }
  if (series.fixed.empty() && series.foundations.empty()) {
    balance(series, mass, part_size(groups, mass), place, history);
    if (series.held_by_pin.empty()) {
      hold_clamped_seat(groups, part_size(groups, mass), history);
    } else {
      hold_by_loaded_pins(series.held_by_pin, groups, place, history);
      history.hold_time =
          history.instants[hardest_instant(history.instants)].time;
    }
  }
  return history;
}

}  // namespace clevis::loads
