#include "mechanism/force_elements/contact.h"

#include <algorithm>
#include <cmath>

#include "mechanism/element_base/acting_element.h"
#include "mechanism/element_base/pressing_end.h"

namespace clevis::mechanism {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Number of the guard of its sliding, beside that of its only end.
constexpr int kSliding = 1;

/// Of the plane, away from it.
Vector3d normal(const PlacedJoint& placed) {
  return placed.axes_a.col(2);
}

/// Its second mode tells whether it slides slowly enough for the peak of its
/// friction to count.
class Contact final : public ActingElement {
 public:
  Contact(const ContactElement& contact, const ReferenceFrame& frame)
      : contact_(contact) {
    R_PW = frame.R_WP.transpose();
    join(contact.plane, contact.center, frame);
    line.frame_a.R_LJ = line.frame_a.R_LJ * with_z_along(contact.normal_L);
  }

  bool presses(int end) const override { return end == 0; }
  bool may_switch() const override { return true; }
  void choose_modes(const ElementResponse& now) override;
  double event_value(int end, const ElementResponse& now) const override;
  void pass_event(int end, const ElementResponse& now) override;
  const char* name_of_change(int end, int mode_before) const override;

  std::vector<ElementGuard> guards() const override;
  double guard_value(const ElementGuard& guard, double t,
                     const ElementResponse& now) const override;
  bool guard_matters(const ElementGuard& guard,
                     const ElementResponse& now) const override {
    return guard.kind != ElementGuard::Kind::kOwn || now.depth[0] > 0.0;
  }

  ElementSpring spring(const Configuration& x,
                       const ElementState& state) const override;
  double stribeck_zone() const override;
  void hold_tangent(const ElementResponse& there,
                    const double* internal) override;
  void release_tangent() override { tangent_.holds = false; }
  PlacedJoint::Levers apart(int end, const ElementResponse& now) const override;
  double apart_bias(int end, const ElementResponse& now, const Twist& a,
                    const Twist& b) const override;
  double sliding_acceleration(const ElementResponse& now, const Twist& a,
                              const Twist& b) const override;

 protected:
  void act(const ActingState& state, const Twist& a, const Twist& b,
           ElementResponse& now) const override;
  std::array<Vector3d, 2> touched(const ElementResponse& now) const override;

 private:
  int mode_of_sliding(const ElementResponse& now) const {
    return modes[0] == 1 && now.sliding.norm() < stribeck_zone() ? 1 : 0;
  }
  double sliding_value(const ElementResponse& now) const;
  /// From M of each body to the point where both touch, in P [m].
  struct Arms {
    Vector3d to_a, to_b;
  };
  Arms arms(const PlacedJoint& placed) const;
  /// Motion of b against a there: velocity, or acceleration without what
  /// velocities cause.
  Vector3d at_point(const PlacedJoint& placed, const Twist& a,
                    const Twist& b) const;

  /// Friction at the state of hold_tangent(); acts instead of the law.
  struct Tangent {
    bool holds = false;
    Vector3d sliding = Vector3d::Zero();
    SlidingFriction friction;
  };

  const ContactElement& contact_;
  Tangent tangent_;
};

Contact::Arms Contact::arms(const PlacedJoint& placed) const {
  const Vector3d to_point = -contact_.radius * normal(placed);
  return {placed.r_a + placed.d + to_point, placed.r_b + to_point};
}

Vector3d Contact::at_point(const PlacedJoint& placed, const Twist& a,
                           const Twist& b) const {
  const auto [to_a, to_b] = arms(placed);
  return b.v + b.w.cross(to_b) - a.v - a.w.cross(to_a);
}

void Contact::act(const ActingState& /*state*/, const Twist& a, const Twist& b,
                  ElementResponse& now) const {
  const PlacedJoint& placed = now.placed;
  const Vector3d n = normal(placed);
  const auto [to_a, to_b] = arms(placed);
  const Vector3d v = at_point(placed, a, b);
  now.q = contact_.radius - n.dot(placed.d);
  now.rate = -n.dot(v);
  now.effort = press(*this, 0, contact_.law, now.q, now.rate, now);
  now.sliding = v + now.rate * n;
  Vector3d f = now.effort * n;
  now.friction = 0.0;
  if (now.effort > 0.0) {
    const Vector3d coefficient =
        tangent_.holds
            ? Vector3d(tangent_.friction.coefficient +
                       tangent_.friction.slope *
                           (now.sliding - tangent_.sliding))
            : sliding_friction(contact_, now.sliding, velocity_tolerance)
                  .coefficient;
    now.friction = coefficient.norm() * now.effort;
    f -= now.effort * coefficient;
  }
  now.on_b = {f, to_b.cross(f)};
  now.on_a = {-f, to_a.cross(Vector3d(-f))};
}

/// Across the plane alone: friction is not held.
ElementSpring Contact::spring(const Configuration& x,
                              const ElementState& state) const {
  const LineTangent across =
      contact_tangent(contact_.law, state.position, state.rate);
  if (across.is_zero()) return {};
  const PlacedJoint placed = placed_in(x);
  const Vector3d n = normal(placed);
  const auto [to_a, to_b] = arms(placed);
  return {.directions = {{.a = {-n, -to_a.cross(n)}, .b = {n, to_b.cross(n)}}},
          .stiffness = Eigen::MatrixXd::Constant(1, 1, across.stiffness),
          .damping = Eigen::MatrixXd::Constant(1, 1, across.damping)};
}

std::array<Vector3d, 2> Contact::touched(const ElementResponse& now) const {
  const Vector3d to_b = -contact_.radius * normal(now.placed);
  return {now.placed.d + to_b, to_b};
}

void Contact::choose_modes(const ElementResponse& now) {
  modes[0] = pressing_mode(now, 0, contact_.law);
  modes[1] = mode_of_sliding(now);
}

double Contact::event_value(int end, const ElementResponse& now) const {
  return end == 1 ? sliding_value(now)
                  : pressing_value(*this, 0, contact_.law, now);
}

void Contact::pass_event(int end, const ElementResponse& now) {
  if (end == 1) {
    modes[1] = 1 - modes[1];
    return;
  }
  pass_pressing(*this, 0, contact_.law, now);
  modes[1] = mode_of_sliding(now);
}

const char* Contact::name_of_change(int end, int mode_before) const {
  return end == 1 ? nullptr : name_of_pressing(modes[0], mode_before);
}

/// Squares: smooth where the sliding turns round, so that a short dip shows.
double Contact::sliding_value(const ElementResponse& now) const {
  const double zone = stribeck_zone();
  if (zone <= 0.0 || modes[0] != 1) return 1.0;
  const double inside = zone - now.sliding.squaredNorm() / zone;
  return modes[1] == 1 ? inside : -inside;
}

double Contact::stribeck_zone() const {
  constexpr double kTimesSpeed = 6.0;  // exp(−36) is round-off
  if (!(contact_.static_friction > 0.0)) return 0.0;
  return (1.0 + kTimesSpeed) *
         std::max(contact_.critical_speed, velocity_tolerance);
}

std::vector<ElementGuard> Contact::guards() const {
  constexpr double kTimes = 4.0;
  std::vector<ElementGuard> all;
  add_pressing_guards(0, contact_.law, all);
  if (contact_.static_friction > 0.0) {
    const double zone =
        std::max(stribeck_zone(), kTimes * contact_.critical_speed);
    all.push_back({ElementGuard::Kind::kOwn, kSliding, zone});
  }
  return all;
}

double Contact::guard_value(const ElementGuard& guard, double t,
                            const ElementResponse& now) const {
  if (guard.kind != ElementGuard::Kind::kOwn) {
    return ActingElement::guard_value(guard, t, now);
  }
  return guard.end == kSliding
             ? guard.level - now.sliding.squaredNorm() / guard.level
             : contact_sign(contact_.law, now.depth[0], now.depth_rate[0]);
}

void Contact::hold_tangent(const ElementResponse& there,
                           const double* /*internal*/) {
  tangent_.sliding = there.sliding;
  tangent_.friction =
      sliding_friction(contact_, there.sliding, velocity_tolerance);
  tangent_.holds = true;
}

PlacedJoint::Levers Contact::apart(int /*end*/,
                                   const ElementResponse& now) const {
  const PlacedJoint& placed = now.placed;
  const Vector3d n = normal(placed);
  const Vector3d to_a = placed.r_a + placed.d;
  return {.a = {-n, -to_a.cross(n)}, .b = {n, placed.r_b.cross(n)}};
}

double Contact::apart_bias(int /*end*/, const ElementResponse& now,
                           const Twist& a, const Twist& b) const {
  const PlacedJoint& placed = now.placed;
  const Vector3d to_a = placed.r_a + placed.d;
  return normal(placed).dot(b.w.cross(b.w.cross(placed.r_b)) -
                            a.w.cross(a.w.cross(to_a)));
}

double Contact::sliding_acceleration(const ElementResponse& now, const Twist& a,
                                     const Twist& b) const {
  const Vector3d n = normal(now.placed);
  const Vector3d sum = at_point(now.placed, a, b);
  return (sum - n.dot(sum) * n).norm();
}

}  // namespace

SlidingFriction sliding_friction(const ContactElement& contact,
                                 const Vector3d& sliding,
                                 double velocity_tolerance) {
  const double speed = sliding.norm();
  const double critical = std::max(contact.critical_speed, velocity_tolerance);
  const double at_rest = contact.static_friction;
  SlidingFriction result;
  if (!(speed > 0.0)) {
    result.slope = 2.0 * at_rest / critical * Matrix3d::Identity();
    return result;
  }
  const double r = speed / critical;
  double coefficient = 2.0 * at_rest * r / (1.0 + r * r);
  double slope = 2.0 * at_rest * (1.0 - r * r) /
                 ((1.0 + r * r) * (1.0 + r * r) * critical);
  if (r > 1.0) {
    const double more =
        (at_rest - contact.kinetic_friction) * std::exp(-(r - 1.0) * (r - 1.0));
    coefficient = contact.kinetic_friction + more;
    slope = -2.0 * (r - 1.0) / critical * more;
  }
  const Vector3d sense = sliding / speed;
  const Matrix3d along = sense * sense.transpose();
  result.coefficient = coefficient * sense;
  result.slope =
      coefficient / speed * (Matrix3d::Identity() - along) + slope * along;
  return result;
}

ElementProperties properties(const ContactElement& contact) {
  return {.type = "contact",
          .presses = true,
          .slides = true,
          .upper = 0.0,
          .size = contact.radius,
          .friction = contact.static_friction};
}

std::unique_ptr<ActingElement> place(const ContactElement& contact,
                                     const ReferenceFrame& frame) {
  return std::make_unique<Contact>(contact, frame);
}

}  // namespace clevis::mechanism
