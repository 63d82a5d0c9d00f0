#include "loads/holds/seat_hold.h"

#include <algorithm>
#include <utility>

#include <Eigen/Geometry>

#include "base/algebra/singular_vectors.h"
#include "loads/seats/force_seats.h"
#include "mechanism/definition/drive_names.h"
#include "mechanism/neighbours/neighbour_inertia.h"

namespace clevis::loads {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;

constexpr Index kWrench = 6;

/// Wrenches by place as wrenches by seat, moments about the seats' points.
MatrixXd by_seat(const MatrixXd& by_place, const std::vector<Index>& seat_of,
                 const std::vector<Seat>& seats) {
  MatrixXd all = MatrixXd::Zero(kWrench * static_cast<Index>(seats.size()),
                                by_place.cols());
  for (std::size_t k = 0; k < seat_of.size(); ++k) {
    const Vector3d& p = seats[static_cast<std::size_t>(seat_of[k])].p_LS;
    for (Index column = 0; column < by_place.cols(); ++column) {
      const auto given = by_place.col(column).segment<kWrench>(
          kWrench * static_cast<Index>(k));
      const Vector3d force = given.head<3>();
      auto moved = all.col(column).segment<kWrench>(kWrench * seat_of[k]);
      moved.head<3>() += force;
      moved.tail<3>() += given.tail<3>() - p.cross(force);
    }
  }
  return all;
}

}  // namespace

SeatHold seat_hold(const mechanism::Neighbours& neighbours,
                   const mechanism::Instant& instant,
                   const std::vector<Seat>& seats) {
  const auto found = mechanism::neighbour_inertia(neighbours, instant);
  const auto& definition = neighbours.definition();
  std::vector<Index> seat_of;
  for (const auto& place : found.places) {
    const auto named = [&](const std::string& name) {
      return std::ranges::find(seats, name, &Seat::name);
    };
    if (place.element >= 0) {
      const auto& element =
          definition.elements[static_cast<std::size_t>(place.element)];
      seat_of.push_back(named(force_seat_name(name_of(element))) -
                        seats.begin());
      continue;
    }
    const std::string& joint =
        definition.joints[static_cast<std::size_t>(place.joint)].name;
    const auto of_joint = named(joint);
    auto of_drive = place.is_drive ? named("drive " + joint) : seats.end();
    for (const auto& drive : definition.drives) {  // several share one face
      if (!place.is_drive || of_drive != seats.end()) break;
      if (drive.joint != place.joint) continue;
      of_drive = named("drive " + mechanism::drive_name(definition, drive));
    }
    seat_of.push_back((of_drive != seats.end() ? of_drive : of_joint) -
                      seats.begin());
  }
  SeatHold hold{.time = instant.t,
                .held = by_seat(found.held, seat_of, seats),
                .weighed = by_seat(found.weighed, seat_of, seats),
                .sprung = by_seat(found.sprung, seat_of, seats),
                .damped = by_seat(found.damped, seat_of, seats)};
  if (found.swinging) {
    const auto& swinging = *found.swinging;
    hold.swinging =
        SwingingBodies{.held = by_seat(swinging.held, seat_of, seats),
                       .sprung = by_seat(swinging.sprung, seat_of, seats),
                       .damped = by_seat(swinging.damped, seat_of, seats),
                       .followed = swinging.followed,
                       .sprung_there = swinging.sprung_there,
                       .damped_there = swinging.damped_there};
  }
  for (const int element : found.left_out) {
    hold.left_out.push_back(
        name_of(definition.elements[static_cast<std::size_t>(element)]));
  }
  if (found.spin.size() > 0) {
    const MatrixXd half = by_seat(found.spin, seat_of, seats);
    hold.spin = by_seat(half.transpose(), seat_of, seats).transpose();
  }
  return hold;
}

SeatHold held_slowly(SeatHold hold) {
  constexpr double kRoundOff = 1e-9;
  if (!hold.swinging) return hold;
  const SwingingBodies swinging = *std::exchange(hold.swinging, std::nullopt);
  hold.left_out.clear();
  // heldᵀ y + followedᵀ z = 0: z follows y, but for what rows leave it.
  const SingularVectors following =
      singular_vectors(swinging.followed.transpose());
  const Index n = following.rank(kRoundOff);
  hold.held = swinging.held * following.left_rows(n);
  const MatrixXd followed = swinging.held * following.U.leftCols(n) *
                            following.sigma.head(n).cwiseInverse().asDiagonal();
  const MatrixXd of_springs =
      swinging.sprung.transpose() - swinging.sprung_there.transpose() *
                                        following.V.leftCols(n) *
                                        followed.transpose();
  // The rest of z strains the springs least.
  const MatrixXd taken = column_space(
      swinging.sprung_there.transpose() * following.left(n), kRoundOff);
  hold.sprung =
      (of_springs - taken * (taken.transpose() * of_springs)).transpose();
  return hold;
}

SeatHold with_wrenches(
    SeatHold hold, const std::function<MatrixXd(const MatrixXd&)>& changed) {
  std::vector<MatrixXd*> of_seats = {&hold.held, &hold.weighed, &hold.sprung,
                                     &hold.damped};
  if (hold.swinging) {
    SwingingBodies& swinging = *hold.swinging;
    of_seats.insert(of_seats.end(),
                    {&swinging.held, &swinging.sprung, &swinging.damped});
  }
  for (MatrixXd* wrenches : of_seats) *wrenches = changed(*wrenches);
  if (hold.spin.size() > 0) {
    const MatrixXd half = changed(hold.spin);
    hold.spin = changed(half.transpose()).transpose();
  }
  return hold;
}

SeatHold on_more_seats(SeatHold hold, std::size_t seats) {
  hold = with_wrenches(std::move(hold), [&](const MatrixXd& wrenches) {
    MatrixXd all =
        MatrixXd::Zero(kWrench * static_cast<Index>(seats), wrenches.cols());
    all.topRows(wrenches.rows()) = wrenches;
    return all;
  });
  if (!hold.zones.empty()) hold.zones.resize(seats);
  return hold;
}

bool are_alike(const SeatHold& a, const SeatHold& b, double apart) {
  const auto is_same = [apart](const MatrixXd& one, const MatrixXd& other) {
    const MatrixXd first = one * one.transpose();
    const MatrixXd second = other * other.transpose();
    return (first - second).norm() <= apart * second.norm();
  };
  const auto swing_alike = [&] {
    if (!a.swinging || !b.swinging) return !a.swinging && !b.swinging;
    return is_same(a.swinging->held, b.swinging->held) &&
           is_same(a.swinging->followed, b.swinging->followed) &&
           is_same(a.swinging->sprung, b.swinging->sprung) &&
           is_same(a.swinging->sprung_there, b.swinging->sprung_there);
  };
  return is_same(a.held, b.held) && is_same(a.weighed, b.weighed) &&
         is_same(a.sprung, b.sprung) && swing_alike();
}

bool has_spin(const SeatHold& hold) {
  constexpr double kRoundOff = 1e-9;  // of masses per second
  return hold.spin.norm() >
         kRoundOff * (hold.weighed * hold.weighed.transpose()).norm();
}

std::size_t hardest_instant(const std::vector<InstantLoad>& instants) {
  const auto size = [](const InstantLoad& load) {
    double sum = 0.0;
    for (const Wrench& wrench : load.wrenches) sum += wrench.force.norm();
    return sum;
  };
  const auto hardest = std::ranges::max_element(instants, {}, size);
  return static_cast<std::size_t>(hardest - instants.begin());
}

}  // namespace clevis::loads
