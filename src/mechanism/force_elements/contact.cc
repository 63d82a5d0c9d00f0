#include "mechanism/force_elements/contact.h"

#include <algorithm>
#include <cmath>

#include "mechanism/element_base/pressing_end.h"

namespace clevis::mechanism {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Number of the guard of its sliding, beside that of its only end.
constexpr int kSliding = 1;

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

  bool presses() const override { return true; }
  bool may_switch() const override { return true; }
  void choose_modes() override;
  double event_value(int end) const override;
  void pass_event(int end) override;
  const char* name_of_change(int end, int mode_before) const override;

  std::vector<ElementGuard> guards() const override;
  double guard_value(const ElementGuard& guard, double t) const override;
  bool guard_matters(const ElementGuard& guard) const override {
    return guard.kind != ElementGuard::Kind::kOwn || depth[0] > 0.0;
  }

  double stribeck_zone() const override;
  void hold_tangent(const double* internal) override;
  void release_tangent() override { tangent_.holds = false; }
  PlacedJoint::Levers apart(int end) const override;
  double apart_bias(int end, const Twist& a, const Twist& b) const override;
  double sliding_acceleration(const Twist& a, const Twist& b) const override;

 protected:
  void act(const ActingState& state, const Twist& a, const Twist& b) override;
  std::array<Vector3d, 2> touched() const override;

 private:
  Vector3d normal() const { return placed.axes_a.col(2); }
  int mode_of_sliding() const {
    return modes[0] == 1 && sliding_.norm() < stribeck_zone() ? 1 : 0;
  }
  double sliding_value() const;
  /// From M of each body to the point where both touch, in P [m].
  struct Arms {
    Vector3d to_a, to_b;
  };
  Arms arms() const;
  /// Motion of b against a there: velocity, or acceleration without what
  /// velocities cause.
  Vector3d at_point(const Twist& a, const Twist& b) const;

  /// Friction at the state of hold_tangent(); acts instead of the law.
  struct Tangent {
    bool holds = false;
    Vector3d sliding = Vector3d::Zero();
    SlidingFriction friction;
  };

  const ContactElement& contact_;
  Vector3d sliding_ = Vector3d::Zero();  ///< [m/s]
  Tangent tangent_;
};

Contact::Arms Contact::arms() const {
  const Vector3d to_point = -contact_.radius * normal();
  return {placed.r_a + placed.d + to_point, placed.r_b + to_point};
}

Vector3d Contact::at_point(const Twist& a, const Twist& b) const {
  const auto [to_a, to_b] = arms();
  return b.v + b.w.cross(to_b) - a.v - a.w.cross(to_a);
}

void Contact::act(const ActingState& /*state*/, const Twist& a,
                  const Twist& b) {
  const Vector3d n = normal();
  const auto [to_a, to_b] = arms();
  const Vector3d v = at_point(a, b);
  q = contact_.radius - n.dot(placed.d);
  rate = -n.dot(v);
  effort = press(*this, 0, contact_.law, q, rate);
  sliding_ = v + rate * n;
  Vector3d f = effort * n;
  friction = 0.0;
  if (effort > 0.0) {
    const Vector3d coefficient =
        tangent_.holds
            ? Vector3d(tangent_.friction.coefficient +
                       tangent_.friction.slope * (sliding_ - tangent_.sliding))
            : sliding_friction(contact_, sliding_, slack).coefficient;
    friction = coefficient.norm() * effort;
    f -= effort * coefficient;
  }
  on_b = {f, to_b.cross(f)};
  on_a = {-f, to_a.cross(Vector3d(-f))};
}

std::array<Vector3d, 2> Contact::touched() const {
  const Vector3d to_b = -contact_.radius * placed.axes_a.col(2);
  return {placed.d + to_b, to_b};
}

void Contact::choose_modes() {
  modes[0] = pressing_mode(*this, 0, contact_.law);
  modes[1] = mode_of_sliding();
}

double Contact::event_value(int end) const {
  return end == 1 ? sliding_value() : pressing_value(*this, 0, contact_.law);
}

void Contact::pass_event(int end) {
  if (end == 1) {
    modes[1] = 1 - modes[1];
    return;
  }
  pass_pressing(*this, 0, contact_.law);
  modes[1] = mode_of_sliding();
}

const char* Contact::name_of_change(int end, int mode_before) const {
  return end == 1 ? nullptr : name_of_pressing(modes[0], mode_before);
}

/// Squares: smooth where the sliding turns round, so that a short dip shows.
double Contact::sliding_value() const {
  const double zone = stribeck_zone();
  if (zone <= 0.0 || modes[0] != 1) return 1.0;
  const double inside = zone - sliding_.squaredNorm() / zone;
  return modes[1] == 1 ? inside : -inside;
}

double Contact::stribeck_zone() const {
  constexpr double kTimesSpeed = 6.0;  // exp(−36) is round-off
  if (!(contact_.static_friction > 0.0)) return 0.0;
  return (1.0 + kTimesSpeed) * std::max(contact_.critical_speed, slack);
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

double Contact::guard_value(const ElementGuard& guard, double t) const {
  if (guard.kind != ElementGuard::Kind::kOwn) {
    return ActingElement::guard_value(guard, t);
  }
  return guard.end == kSliding
             ? guard.level - sliding_.squaredNorm() / guard.level
             : contact_sign(contact_.law, depth[0], depth_rate[0]);
}

void Contact::hold_tangent(const double* /*internal*/) {
  tangent_.sliding = sliding_;
  tangent_.friction = sliding_friction(contact_, sliding_, slack);
  tangent_.holds = true;
}

PlacedJoint::Levers Contact::apart(int /*end*/) const {
  const Vector3d n = normal();
  const Vector3d to_a = placed.r_a + placed.d;
  return {.a = {-n, -to_a.cross(n)}, .b = {n, placed.r_b.cross(n)}};
}

double Contact::apart_bias(int /*end*/, const Twist& a, const Twist& b) const {
  const Vector3d to_a = placed.r_a + placed.d;
  return normal().dot(b.w.cross(b.w.cross(placed.r_b)) -
                      a.w.cross(a.w.cross(to_a)));
}

double Contact::sliding_acceleration(const Twist& a, const Twist& b) const {
  const Vector3d n = normal();
  const Vector3d sum = at_point(a, b);
  return (sum - n.dot(sum) * n).norm();
}

}  // namespace

SlidingFriction sliding_friction(const ContactElement& contact,
                                 const Vector3d& sliding, double slack) {
  const double speed = sliding.norm();
  const double critical = std::max(contact.critical_speed, slack);
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

ElementProperties properties(const ContactElement& /*contact*/) {
  return {.type = "contact", .presses = true, .slides = true};
}

std::unique_ptr<ActingElement> place(const ContactElement& contact,
                                     const ReferenceFrame& frame) {
  return std::make_unique<Contact>(contact, frame);
}

}  // namespace clevis::mechanism
