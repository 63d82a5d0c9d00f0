#include "loads/holds/neighbours_over_motion.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>

#include "loads/holds/seat_hold.h"
#include "mechanism/neighbours/elements_at_rest.h"

namespace clevis::loads {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;

constexpr Index kMotion = 6;

bool lets_go(const mechanism::Instant& instant, std::size_t element) {
  return element >= instant.elements.size() ||
         instant.elements[element].effort == 0.0;
}

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
    const auto sticking = mechanism::sticking_coordinates(definition_, instant);
    if (sticking.empty()) return neighbours_;
    Coordinates coordinates;
    for (const auto& one : sticking) {
      coordinates.emplace_back(one.joint, one.coordinate);
    }
    auto& found = stuck_[coordinates];
    if (!found) {
      mechanism::MechanismDefinition held = definition_;
      held.drives.insert(held.drives.end(), sticking.begin(), sticking.end());
      found = std::make_unique<Stuck>(std::move(held), body_);
      leave_out(left_out_, found->neighbours);
    }
    return found->neighbours;
  }

  std::map<std::size_t, SeatHold> known;  ///< by place

 private:
  using Coordinates = std::vector<std::pair<int, int>>;  ///< of joints
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
  std::map<Coordinates, std::unique_ptr<Stuck>> stuck_;
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
  constexpr double kMost = 0.5;
  Elements passing;
  for (std::size_t e = 0; e < definition_.elements.size(); ++e) {
    if (properties(definition_.elements[e]).presses &&
        std::ranges::any_of(places_, [&](const Place& place) {
          return lets_go(place.instant, e);
        })) {
      letting_go_.push_back(e);
      if (pressed_share(e) < kMost) passing.push_back(e);
    }
  }
  all_ = std::make_unique<Holder>(definition_, body, passing);
  if (letting_go_.size() > passing.size()) {
    lasting_ = std::make_unique<Holder>(definition_, body, letting_go_);
  }
}

NeighboursOverMotion::~NeighboursOverMotion() = default;

double NeighboursOverMotion::pressed_share(std::size_t element) const {
  double pressed = 0.0;
  for (std::size_t i = 0; i + 1 < places_.size(); ++i) {
    if (lets_go(places_[i].instant, element) &&
        lets_go(places_[i + 1].instant, element)) {
      continue;
    }
    pressed += places_[i + 1].instant.t - places_[i].instant.t;
  }
  const double whole = places_.back().instant.t - places_.front().instant.t;
  return whole > 0.0 ? pressed / whole : 0.0;
}

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

SeatHold NeighboursOverMotion::hold_of(Holder& holder, double time) {
  const std::size_t next = place_next_to(time);
  const std::scoped_lock lock(mutex_);
  const auto [hold, is_new] = holder.known.try_emplace(next);
  if (is_new) {
    const Place& place = places_[next];
    hold->second = hold_by(holder.at(place.instant), place);
  }
  return hold->second;
}

SeatHold NeighboursOverMotion::hold(double time) {
  return hold_of(*all_, time);
}

SeatHold NeighboursOverMotion::lasting_hold(double time) {
  return hold_of(lasting_ ? *lasting_ : *all_, time);
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
  if (is_new) gains->second = found_gains(places_[instant]);
  return gains->second;
}

SeatGains NeighboursOverMotion::found_gains(const Place& place) const {
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
  const Holder& holder = lasting_ ? *lasting_ : *all_;
  const auto found =
      load_gains(holder.neighbours(), place.instant, acting, wanted_);
  SeatGains gains{std::vector<std::size_t>(seats_.size()),
                  to_point.transpose() * found * to_point + of_way};
  std::iota(gains.seats.begin(), gains.seats.end(), std::size_t{0});
  return gains;
}

}  // namespace clevis::loads
