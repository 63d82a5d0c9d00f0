#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include <Eigen/Core>
#include <Eigen/LU>

namespace clevis::mechanism::testing {

/// Crank, coupler and rocker, uniform bars of 2 kg/m in the plane, the crank's
/// pin in the origin, the rocker's on x; at the start the crank turns.
struct CrankRocker {
  double ground = 0.20;                               ///< [m]
  std::array<double, 3> length = {0.05, 0.18, 0.12};  ///< [m]
  double angle = 0.5, spin = 30.0;                    ///< [rad], [rad/s]
  double g = 9.81;                                    ///< along −y [m/s²]

  double mass(std::size_t i) const { return 2.0 * length[i]; }
  double inertia(std::size_t i) const {
    return mass(i) * length[i] * length[i] / 12.0;
  }

  /// Per body; rates and velocities of the origins per rate of the crank.
  struct Place {
    std::array<Eigen::Vector2d, 3> origin, velocity;
    std::array<double, 3> angle{}, rate{};
  };

  static Eigen::Vector2d along(double angle) {
    return {std::cos(angle), std::sin(angle)};
  }
  static Eigen::Vector2d across(double angle) {
    return {-std::sin(angle), std::cos(angle)};
  }

  /// Columns: what a turn of coupler and of rocker opens the loop by.
  Eigen::Matrix2d loop(const Place& at) const {
    Eigen::Matrix2d J;
    J.col(0) = length[1] * across(at.angle[1]);
    J.col(1) = -length[2] * across(at.angle[2]);
    return J;
  }

  /// Where the circles of coupler and rocker meet above the line of their
  /// centres.
  Place at(double phi) const {
    Place place;
    const Eigen::Vector2d P = length[0] * along(phi), G(ground, 0.0);
    const Eigen::Vector2d apart = G - P;
    const double distance = apart.norm();
    const double foot =
        (distance * distance + length[1] * length[1] - length[2] * length[2]) /
        (2.0 * distance);
    const double height = std::sqrt(length[1] * length[1] - foot * foot);
    const Eigen::Vector2d way = apart / distance;
    const Eigen::Vector2d Q =
        P + foot * way + height * Eigen::Vector2d(-way.y(), way.x());
    place.origin = {Eigen::Vector2d::Zero(), P, G};
    place.angle = {phi, std::atan2(Q.y() - P.y(), Q.x() - P.x()),
                   std::atan2(Q.y() - G.y(), Q.x() - G.x())};
    const Eigen::Vector2d v_P = length[0] * across(phi);
    const Eigen::Vector2d rates = loop(place).inverse() * -v_P;
    place.rate = {1.0, rates[0], rates[1]};
    place.velocity = {Eigen::Vector2d::Zero(), v_P, Eigen::Vector2d::Zero()};
    return place;
  }
};

/// The same in one coordinate, the crank's angle, by virtual power.
class CrankRockerEquations {
 public:
  explicit CrankRockerEquations(const CrankRocker& v)
      : v_(v), y_(v.angle, v.spin) {}

  /// Runge–Kutta of order 4, n steps.
  void advance(double duration, long n) {
    const double h = duration / static_cast<double>(n);
    for (long i = 0; i < n; ++i) {
      const Eigen::Vector2d a = rate(y_), b = rate(y_ + 0.5 * h * a),
                            c = rate(y_ + 0.5 * h * b), d = rate(y_ + h * c);
      y_ += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
    }
  }

  double angle() const { return y_[0]; }

 private:
  Eigen::Vector2d rate(const Eigen::Vector2d& y) const {
    const CrankRocker::Place at = v_.at(y[0]);
    const double w2 = y[1] * y[1];
    // accelerations at constant rate of the crank
    const auto inward = [&](std::size_t i) {
      return Eigen::Vector2d(-v_.length[i] * at.rate[i] * at.rate[i] * w2 *
                             CrankRocker::along(at.angle[i]));
    };
    const Eigen::Vector2d turns =
        v_.loop(at).inverse() * (inward(2) - inward(0) - inward(1));
    const std::array<double, 3> turn = {0.0, turns[0], turns[1]};
    const std::array<Eigen::Vector2d, 3> a_origin = {
        Eigen::Vector2d::Zero(), inward(0), Eigen::Vector2d::Zero()};
    double mass = 0.0, power = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double half = 0.5 * v_.length[i];
      const Eigen::Vector2d across = CrankRocker::across(at.angle[i]);
      const Eigen::Vector2d v = at.velocity[i] + half * at.rate[i] * across;
      const Eigen::Vector2d a =
          a_origin[i] + 0.5 * inward(i) + half * turn[i] * across;
      mass += v_.mass(i) * v.squaredNorm() +
              v_.inertia(i) * at.rate[i] * at.rate[i];
      power += v_.mass(i) * (v.dot(a) + v_.g * v.y()) +
               v_.inertia(i) * turn[i] * at.rate[i];
    }
    return {y[1], -power / mass};
  }

  CrankRocker v_;
  Eigen::Vector2d y_;  // angle, rate
};

}  // namespace clevis::mechanism::testing
