#pragma once

#include <array>
#include <cmath>
#include <complex>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace clevis::mechanism::testing {

/// Six corners of a cube [m]: bar i, of five, lies from corner i to the next,
/// the ground from the last to the first.
inline std::array<Eigen::Vector3d, 6> bricard_corners() {
  using Eigen::Vector3d;
  return {Vector3d(0.0, 0.0, 0.0),  Vector3d(1.0, 0.0, 0.0),
          Vector3d(1.0, -1.0, 0.0), Vector3d(1.0, -1.0, 1.0),
          Vector3d(0.0, -1.0, 1.0), Vector3d(0.0, 0.0, 1.0)};
}

/// Axes of bar i (5: of the ground): x along it, z along the hinge at its
/// start.
inline Eigen::Matrix3d bricard_axes(std::size_t i) {
  const auto corners = bricard_corners();
  const Eigen::Vector3d along = corners[(i + 1) % 6] - corners[i];
  const Eigen::Vector3d before = corners[i] - corners[(i + 5) % 6];
  Eigen::Matrix3d R;
  R.col(0) = along;
  R.col(2) = before.cross(along);
  R.col(1) = R.col(2).cross(R.col(0));
  return R;
}

/// Of a bar of 1 kg about its centre [kg m²].
inline Eigen::Vector3d bricard_bar_inertia() {
  return {1e-4, 1.0 / 12.0, 1.0 / 12.0};
}

/// Bricard's mechanism by its closed form: successive bars turn by θ and φ in
/// turn, cos θ + cos φ + cos θ cos φ = 0, both right angles at the start. A
/// parameter s runs along that curve, θ' = sin φ (1 + cos θ), φ' = −sin θ
/// (1 + cos φ), and M s'' + M' s'²/2 + V' = 0, with derivatives by complex
/// steps.
class BricardEquations {
 public:
  /// Runge–Kutta of order 4, n steps.
  void advance(double duration, long n) {
    const double h = duration / static_cast<double>(n);
    for (long i = 0; i < n; ++i) {
      const State a = rate(y_), b = rate(y_ + 0.5 * h * a),
                  c = rate(y_ + 0.5 * h * b), d = rate(y_ + h * c);
      y_ += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
    }
  }

  using State = Eigen::Vector3d;  ///< θ, φ, s'
  const State& state() const { return y_; }

  /// Where bar 3 (from 0) begins, opposite to the ground's first corner [m].
  Eigen::Vector3d corner() const { return corner(y_); }
  static Eigen::Vector3d corner(const State& y) {
    return chain({y[0], y[1]}).corner.real();
  }
  /// Kinetic and potential [J].
  static double energy(const State& y) {
    const Chain at = chain({y[0], y[1]});
    return 0.5 * at.mass.real() * y[2] * y[2] + at.potential.real();
  }

  /// Of the chain's end from the ground's last corner [m]: 0.
  double gap() const {
    return (chain({y_[0], y_[1]}).end.real() - bricard_corners()[5]).norm();
  }

  static State rate(const State& y) {
    const std::array<Complex, 2> q{y[0], y[1]}, rates = along(q);
    const Complex step(0.0, 1e-30);
    const Chain at = chain({q[0] + step * rates[0], q[1] + step * rates[1]});
    const double mass_by_s = at.mass.imag() / 1e-30;
    const double potential_by_s = at.potential.imag() / 1e-30;
    return {rates[0].real() * y[2], rates[1].real() * y[2],
            -(0.5 * mass_by_s * y[2] * y[2] + potential_by_s) / at.mass.real()};
  }

 private:
  using Complex = std::complex<double>;
  using Vector = Eigen::Vector3cd;

  struct Chain {
    Vector corner, end;
    Complex mass, potential;  // mass: twice the kinetic energy at s' = 1
  };

  static Complex product(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  static std::array<Complex, 2> along(const std::array<Complex, 2>& q) {
    return {std::sin(q[1]) * (1.0 + std::cos(q[0])),
            -std::sin(q[0]) * (1.0 + std::cos(q[1]))};
  }

  static Vector across(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0]};
  }

  static Chain chain(const std::array<Complex, 2>& q) {
    const std::array<Complex, 2> rates = along(q);
    const Eigen::Vector3d inertia = bricard_bar_inertia();
    Eigen::Matrix3cd R = bricard_axes(5).cast<Complex>();
    Vector w = Vector::Zero(), p = Vector::Zero(), v = Vector::Zero();
    Chain all{};
    for (std::size_t i = 0; i < 5; ++i) {
      const Complex turn = q[i % 2] - 0.5 * M_PI;
      Eigen::Matrix3cd about_z = Eigen::Matrix3cd::Identity();
      about_z(0, 0) = about_z(1, 1) = std::cos(turn);
      about_z(1, 0) = std::sin(turn);
      about_z(0, 1) = -about_z(1, 0);
      const Eigen::Matrix3d step =
          bricard_axes((i + 5) % 6).transpose() * bricard_axes(i);
      R = R * step.cast<Complex>() * about_z;
      w += rates[i % 2] * R.col(2);
      if (i == 3) all.corner = p;
      const Vector half = 0.5 * R.col(0);
      const Vector v_centre = v + across(w, half);
      const Vector w_bar = R.transpose() * w;
      all.mass += product(v_centre, v_centre);
      for (int k = 0; k < 3; ++k) all.mass += inertia[k] * w_bar[k] * w_bar[k];
      all.potential += 9.81 * (p[1] + half[1]);
      v += across(w, 2.0 * half);
      p += 2.0 * half;
    }
    all.end = p;
    return all;
  }

  State y_{0.5 * M_PI, 0.5 * M_PI, 0.0};
};

}  // namespace clevis::mechanism::testing
