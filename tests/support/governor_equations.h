#pragma once

#include <array>
#include <cmath>

namespace clevis::mechanism::testing {

/// Flyball governor: a shaft about the world's z; two arms of 1 m hinged to
/// its top, each with a ball at its end; a sleeve that slides down the shaft,
/// held to the middle of each arm by a stiff spring and damper.
struct Governor {
  double arm_mass = 6.0, arm_centre = 0.9;         ///< [kg], [m] from the hinge
  double arm_axial = 0.02, arm_transverse = 0.35;  ///< about the centre [kg m²]
  double sleeve_mass = 1.0, sleeve_spin = 0.1;     ///< [kg], [kg m²]
  double shaft_spin = 0.1;                         ///< [kg m²]
  double middle = 0.5;                             ///< of the arm [m]
  double stiffness = 8e5, damping = 4e4, free = 0.5;  ///< [N/m], [N s/m], [m]
  double angle = M_PI / 6.0;  ///< of the arms from downwards, at the start
  double spin = 2.0 * M_PI;   ///< at the start [rad/s]
  double g = 9.81;

  /// Depth of the sleeve at which the springs are free [m].
  double start_depth() const {
    const double across = middle * std::sin(angle);
    return middle * std::cos(angle) + std::sqrt(free * free - across * across);
  }
};

/// The same in three coordinates: depth of the sleeve, angle of both arms and
/// the spin that the angular momentum leaves.
class GovernorEquations {
 public:
  explicit GovernorEquations(const Governor& v)
      : v_(v),
        about_hinge_(v.arm_transverse +
                     v.arm_mass * v.arm_centre * v.arm_centre),
        y_{v.start_depth(), v.angle, 0.0, 0.0},
        momentum_(spin_inertia(v.angle) * v.spin) {}

  double depth() const { return y_[0]; }
  double angle() const { return y_[1]; }
  double spin() const { return momentum_ / spin_inertia(y_[1]); }

  /// Depth, angle, their rates.
  using State = std::array<double, 4>;
  const State& state() const { return y_; }

  /// Runge–Kutta of order 4, n steps.
  void advance(double duration, long n) {
    const double h = duration / static_cast<double>(n);
    for (long i = 0; i < n; ++i) {
      const State a = rate(y_), b = rate(along(a, 0.5 * h)),
                  c = rate(along(b, 0.5 * h)), d = rate(along(c, h));
      for (std::size_t k = 0; k < 4; ++k) {
        y_[k] += h / 6.0 * (a[k] + 2.0 * b[k] + 2.0 * c[k] + d[k]);
      }
    }
  }

  State rate(const State& y) const {
    const double depth = y[0], sine = std::sin(y[1]), cosine = std::cos(y[1]);
    const double h = v_.middle;
    const double length =
        std::sqrt(h * h + depth * depth - 2.0 * h * depth * cosine);
    const double by_depth = (depth - h * cosine) / length;
    const double by_angle = h * depth * sine / length;
    const double force = -v_.stiffness * (length - v_.free) -
                         v_.damping * (by_depth * y[2] + by_angle * y[3]);
    const double w = momentum_ / spin_inertia(y[1]);
    return {y[2], y[3], v_.g + 2.0 * force * by_depth / v_.sleeve_mass,
            ((about_hinge_ - v_.arm_axial) * sine * cosine * w * w -
             v_.arm_mass * v_.g * v_.arm_centre * sine + force * by_angle) /
                about_hinge_};
  }

 private:
  State along(const State& slope, double h) const {
    State y = y_;
    for (std::size_t k = 0; k < 4; ++k) y[k] += h * slope[k];
    return y;
  }

  double spin_inertia(double angle) const {
    const double s = std::sin(angle), c = std::cos(angle);
    return v_.shaft_spin + v_.sleeve_spin +
           2.0 * (about_hinge_ * s * s + v_.arm_axial * c * c);
  }

  Governor v_;
  double about_hinge_;
  State y_;
  double momentum_;
};

}  // namespace clevis::mechanism::testing
