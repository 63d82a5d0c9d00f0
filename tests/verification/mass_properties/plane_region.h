#pragma once

#include <array>
#include <cmath>
#include <numbers>

namespace clevis::verification {

/// Area moments of a plane region: ∫ dA, ∫ x dA, ∫ y dA, ∫ x² dA, ∫ y² dA,
/// ∫ xy dA.
struct AreaMoments {
  double area{}, x{}, y{}, xx{}, yy{}, xy{};

  AreaMoments& operator+=(const AreaMoments& other) {
    area += other.area;
    x += other.x;
    y += other.y;
    xx += other.xx;
    yy += other.yy;
    xy += other.xy;
    return *this;
  }
};

/// Moments of the region inside a closed outline of straight lines and arcs,
/// by Green's theorem, piece after piece counter-clockwise; a hole is a
/// clockwise circle. The integrands of an arc are trigonometric polynomials of
/// degree 4: eight Gauss points on 32 pieces leave only round-off.
class Outline {
 public:
  /// A point of a piece and its derivative by the piece's parameter.
  struct State {
    double x, y, dx, dy;
  };

  /// A piece as a smooth function State(double) of a parameter from 0 to 1.
  template <typename Path>
  void piece(const Path& path) {
    constexpr int kParts = 32;
    constexpr std::array<double, 4> kAt = {
        0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
        0.9602898564975363};
    constexpr std::array<double, 4> kWeight = {
        0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
        0.1012285362903763};
    for (int part = 0; part < kParts; ++part) {
      for (int k = 0; k < 8; ++k) {
        const double at = (k < 4 ? 1.0 : -1.0) * kAt[std::size_t(k % 4)];
        add(path((part + 0.5 + 0.5 * at) / kParts),
            0.5 * kWeight[std::size_t(k % 4)] / kParts);
      }
    }
  }

  void line(double x0, double y0, double x1, double y1) {
    piece([&](double t) {
      return State{x0 + t * (x1 - x0), y0 + t * (y1 - y0), x1 - x0, y1 - y0};
    });
  }

  /// From angle `from` to `to`; to < from runs clockwise.
  void arc(double cx, double cy, double radius, double from, double to) {
    piece([&](double t) {
      const double a = from + t * (to - from), rate = to - from;
      return State{cx + radius * std::cos(a), cy + radius * std::sin(a),
                   -radius * rate * std::sin(a), radius * rate * std::cos(a)};
    });
  }

  void hole(double cx, double cy, double radius) {
    arc(cx, cy, radius, 2.0 * std::numbers::pi, 0.0);
  }

  const AreaMoments& moments() const { return sum_; }

 private:
  void add(const State& s, double weight) {
    sum_ += {.area = weight * 0.5 * (s.x * s.dy - s.y * s.dx),
             .x = weight * 0.5 * s.x * s.x * s.dy,
             .y = -weight * 0.5 * s.y * s.y * s.dx,
             .xx = weight * s.x * s.x * s.x / 3.0 * s.dy,
             .yy = -weight * s.y * s.y * s.y / 3.0 * s.dx,
             .xy = weight * 0.5 * s.x * s.x * s.y * s.dy};
  }

  AreaMoments sum_;
};

}  // namespace clevis::verification
