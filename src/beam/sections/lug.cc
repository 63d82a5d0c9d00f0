#include "beam/sections/lug.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

namespace clevis::beam {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr int kDirections = 360;
// The wall of the bore itself is left out by this much of its radius; chords
// of a coarse mesh (facets of 22.5°) lie 2 % inside.
constexpr double kWallGap = 0.02;

using Segment = std::array<Vector2d, 2>;

double cross(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

struct Crossings {
  double first = std::numeric_limits<double>::infinity();
  int count = 0;
};

// Where a ray from the origin meets the segments beyond `start`. An end on
// the ray counts to its left, so that a vertex is met once.
Crossings cast(const std::vector<Segment>& segments, const Vector2d& direction,
               double start) {
  Crossings crossings;
  for (const auto& [a, b] : segments) {
    const double side_a = cross(direction, a), side_b = cross(direction, b);
    if ((side_a >= 0.0) == (side_b >= 0.0)) continue;
    const Vector2d hit = a + side_a / (side_a - side_b) * (b - a);
    const double distance = hit.dot(direction);
    if (distance <= start) continue;
    crossings.first = std::min(crossings.first, distance);
    ++crossings.count;
  }
  return crossings;
}

}  // namespace

LugGeometry::LugGeometry(const part::Bore& bore, const Outline& outline)
    : bore_(bore),
      e_1_(bore.axis_L.unitOrthogonal()),
      e_2_(bore.axis_L.cross(e_1_)) {
  std::vector<Segment> segments;
  for (const auto& [a, b] : outline) {
    const Vector3d from = a - bore.p_LC, to = b - bore.p_LC;
    segments.push_back({Vector2d(from.dot(e_1_), from.dot(e_2_)),
                        Vector2d(to.dot(e_1_), to.dot(e_2_))});
  }
  int surrounded = 0;
  for (int i = 0; i < kDirections; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kDirections;
    const Crossings crossings =
        cast(segments, {std::cos(angle), std::sin(angle)},
             (1.0 + kWallGap) * bore.radius);
    edges_.push_back(crossings.first);
    surrounded += crossings.count % 2;
  }
  is_bore_ = surrounded == kDirections;
}

double LugGeometry::edge(const Vector3d& direction) const {
  const double turns = std::atan2(direction.dot(e_2_), direction.dot(e_1_)) /
                       (2.0 * std::numbers::pi);
  const double at = kDirections * (turns - std::floor(turns));
  const auto i = static_cast<std::size_t>(at) % kDirections;
  const double t = at - std::floor(at);
  return (1.0 - t) * edges_[i] + t * edges_[(i + 1) % kDirections];
}

double LugGeometry::smallest_edge() const {
  return *std::ranges::min_element(edges_);
}

LugStress lug_stress(const LugGeometry& lug, const part::Bore& bore,
                     const Vector3d& force) {
  const Vector3d across = force - force.dot(bore.axis_L) * bore.axis_L;
  const double F = across.norm();
  LugStress stress;
  stress.bearing = F / (2.0 * bore.radius * bore.length);
  if (!lug.is_bore() || F == 0.0) return stress;
  const double ahead = lug.edge(across);
  // Round-off must not decide for a ring, whose edges are all equally far.
  if (ahead > (1.0 + 1e-3) * lug.edge(-across)) return stress;
  const Vector3d beside = bore.axis_L.cross(across);
  const double ligaments =
      lug.edge(beside) + lug.edge(-beside) - 2.0 * bore.radius;
  stress.net_section = F / (ligaments * bore.length);
  stress.shear_out =
      std::sqrt(3.0) * F / (2.0 * bore.length * (ahead - bore.radius));
  return stress;
}

}  // namespace clevis::beam
