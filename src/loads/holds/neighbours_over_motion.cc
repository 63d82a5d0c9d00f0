#include "loads/holds/neighbours_over_motion.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>

#include "loads/holds/resting_contacts.h"
#include "loads/holds/seat_hold.h"
#include "mechanism/neighbours/elements_at_rest.h"

namespace clevis::loads {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;

constexpr Index kMotion = 6;

void leave_out(const std::vector<std::size_t>& elements,
               mechanism::Neighbours& neighbours) {
  for (const std::size_t e : elements) neighbours.leave_out(e);
}

}  // namespace

class NeighboursOverMotion::Holder {
 public:
  /// @param definition  outlives the object.
  Holder(const mechanism::MechanismDefinition& definition,
         mechanism::BodyIndex body, Elements left_out)
      : definition_(definition),
        body_(body),
        left_out_(std::move(left_out)),
        neighbours_(definition_, body) {
    leave_out(left_out_, neighbours_);
  }

  const mechanism::Neighbours& neighbours() const { return neighbours_; }
  /// With the friction that sticks at the instant.
  const mechanism::Neighbours& at(const mechanism::Instant& instant) {
    const auto [drives, lines] = mechanism::sticking(definition_, instant);
    if (drives.empty() && lines.empty()) return neighbours_;
    Holding holding{{}, lines};
    for (const auto& drive : drives) {
      holding.first.emplace_back(drive.joint, drive.coordinate);
    }
    auto& found = stuck_[holding];
    if (!found) {
      mechanism::MechanismDefinition held = definition_;
      held.drives.insert(held.drives.end(), drives.begin(), drives.end());
      found = std::make_unique<Stuck>(std::move(held), body_);
      leave_out(left_out_, found->neighbours);
      for (const std::size_t line : lines) found->neighbours.hold_along(line);
    }
    return found->neighbours;
  }

  std::map<std::size_t, SeatHold> known;  ///< by place

 private:
  /// Coordinates of joints, lines of elements.
  using Holding = std::pair<std::vector<std::pair<int, int>>, Elements>;
  /// A mechanism with some friction that sticks.
  struct Stuck {
    Stuck(mechanism::MechanismDefinition given, mechanism::BodyIndex body)
        : definition(std::move(given)), neighbours(definition, body) {}

    mechanism::MechanismDefinition definition;
    mechanism::Neighbours neighbours;
  };

  const mechanism::MechanismDefinition& definition_;
  mechanism::BodyIndex body_;
  Elements left_out_;
  mechanism::Neighbours neighbours_;
  std::map<Holding, std::unique_ptr<Stuck>> stuck_;
};

NeighboursOverMotion::NeighboursOverMotion(
    const mechanism::MechanismDefinition& definition, mechanism::BodyIndex body,
    std::vector<Seat> seats, std::vector<mechanism::LoadPlace> acting,
    std::vector<Place> places, double wanted)
    : definition_(definition),
      body_(body),
      seats_(std::move(seats)),
      acting_(std::move(acting)),
      places_(std::move(places)),
      wanted_(wanted) {
  std::vector<const mechanism::Instant*> instants;
  for (const Place& place : places_) instants.push_back(&place.instant);
  const mechanism::Neighbours& all = holder({}).neighbours();
  bouncing_.resize(places_.size());
  for (std::size_t e = 0; e < definition_.elements.size(); ++e) {
    if (!properties(definition_.elements[e]).presses ||
        std::ranges::none_of(places_, [&](const Place& place) {
          return lets_go(place.instant, e);
        })) {
      continue;
    }
    letting_go_.push_back(e);
    for (const std::size_t i : bounces(all, e, instants)) {
      bouncing_[i].push_back(e);
    }
  }
}

NeighboursOverMotion::~NeighboursOverMotion() = default;

bool NeighboursOverMotion::presses_meanwhile(
    const mechanism::Instant& instant) const {
  return std::ranges::any_of(letting_go_, [&](std::size_t e) {
    return !lets_go(instant, e);
  });
}

std::size_t NeighboursOverMotion::place_next_to(double time) const {
  const auto nearest =
      std::ranges::min_element(places_, {}, [&](const Place& place) {
        return std::abs(place.instant.t - time);
      });
  return static_cast<std::size_t>(nearest - places_.begin());
}

SeatHold NeighboursOverMotion::hold_by(const mechanism::Neighbours& neighbours,
                                       const Place& place) const {
  SeatHold hold = seat_hold(neighbours, place.instant, seats_);
  hold.zones = place.zones;
  hold.is_pressed_meanwhile = presses_meanwhile(place.instant);
  return hold;
}

NeighboursOverMotion::Holder& NeighboursOverMotion::holder(
    const Elements& left_out) {
  auto& found = holders_[left_out];
  if (!found) found = std::make_unique<Holder>(definition_, body_, left_out);
  return *found;
}

SeatHold NeighboursOverMotion::hold_at(std::size_t next,
                                       const Elements& left_out) {
  const std::scoped_lock lock(mutex_);
  Holder& by = holder(left_out);
  const auto [hold, is_new] = by.known.try_emplace(next);
  if (is_new) {
    const Place& place = places_[next];
    hold->second = hold_by(by.at(place.instant), place);
  }
  return hold->second;
}

SeatHold NeighboursOverMotion::hold(double time) {
  const std::size_t next = place_next_to(time);
  return hold_at(next, bouncing_[next]);
}

SeatHold NeighboursOverMotion::lasting_hold(double time) {
  return hold_at(place_next_to(time), letting_go_);
}

std::optional<SeatHold> NeighboursOverMotion::hold_at_rest(double time) const {
  const Place& place = places_[place_next_to(time)];
  const auto yielding = mechanism::yielding_at_rest(definition_, place.instant);
  if (!yielding) return std::nullopt;
  mechanism::Neighbours neighbours(*yielding, body_);
  leave_out(letting_go_, neighbours);
  return hold_by(neighbours, place);
}

SeatGains NeighboursOverMotion::gains(std::size_t instant) {
  const std::scoped_lock lock(mutex_);
  const auto [gains, is_new] = gains_.try_emplace(instant);
  if (is_new) {
    gains->second =
        found_gains(holder(letting_go_).neighbours(), places_[instant]);
  }
  return gains->second;
}

SeatGains NeighboursOverMotion::found_gains(
    const mechanism::Neighbours& neighbours, const Place& place) const {
  std::vector<mechanism::LoadPlace> acting = acting_;
  MatrixXd to_point = MatrixXd::Identity(kMotion * std::ssize(acting),
                                         kMotion * std::ssize(acting));
  MatrixXd of_way = MatrixXd::Zero(to_point.rows(), to_point.cols());
  const auto& pose = place.instant.bodies[static_cast<std::size_t>(body_)].pose;
  for (std::size_t s = 0; s < acting.size(); ++s) {
    if (!seats_[s].slide) continue;
    const auto joint = static_cast<std::size_t>(acting[s].index);
    const auto& reaction = place.instant.joints[joint];
    acting[s].p_LS = pose.R_WL.transpose() * (reaction.p_WJ - pose.p_WL);
    const Vector3d way = acting[s].p_LS - seats_[s].p_LS;
    const Index at = kMotion * static_cast<Index>(s);
    for (Index k = 0; k < 3; ++k) {
      const Vector3d turned = Vector3d::Unit(k).cross(way);
      to_point.block<3, 1>(at, at + 3 + k) = turned;
    }
    // The way from the seat's point to the joint's turns, too.
    const double sign = definition_.joints[joint].body_b == body_ ? 1.0 : -1.0;
    const Matrix3d outer =
        sign * pose.R_WL.transpose() * reaction.f_W * way.transpose();
    of_way.block<3, 3>(at + 3, at + 3) = 0.5 * (outer + outer.transpose()) -
                                         outer.trace() * Matrix3d::Identity();
  }
  const auto found = load_gains(neighbours, place.instant, acting, wanted_);
  SeatGains gains{std::vector<std::size_t>(seats_.size()),
                  to_point.transpose() * found * to_point + of_way};
  std::iota(gains.seats.begin(), gains.seats.end(), std::size_t{0});
  return gains;
}

}  // namespace clevis::loads
