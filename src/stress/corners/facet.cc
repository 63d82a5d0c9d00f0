#include "stress/corners/facet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <Eigen/Geometry>

namespace clevis::stress {
namespace {

using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;
constexpr double kSmallKink = 15.0;  // degrees

/// Whether two corners, side by side, turn alike as those of a curve do.
bool turn_alike(const HeldCorner& one, const HeldCorner& other) {
  constexpr double kAlike = 3.0;
  constexpr double kParallel = 0.9;
  const double ratio = *one.kink / *other.kink;
  if (!(ratio > 1.0 / kAlike && ratio < kAlike)) return false;
  const Vector3d& axis = one.corner.axis;
  if (std::abs(axis.dot(other.corner.axis)) < kParallel) return false;
  const Vector3d arm = other.corner.at - one.corner.at;
  // Side by side, not end to end along a rim.
  const double across = (arm - axis.dot(arm) * axis).norm();
  const double near = std::max(one.corner.reach, other.corner.reach);
  return across < near && across > std::abs(axis.dot(arm));
}

/// On which side of a corner another stands like it, one facet away: 0 or 1;
/// nothing if it does not.
std::optional<std::size_t> side_of_next(const HeldCorner& one,
                                        const HeldCorner& other) {
  constexpr double kAlong = 0.85;  // facets of curved cells bend a little
  constexpr double kNear = 1.1;
  if (!turn_alike(one, other)) return std::nullopt;
  const Vector3d& axis = one.corner.axis;
  const Vector3d arm = other.corner.at - one.corner.at;
  const Vector3d across = arm - axis.dot(arm) * axis;
  for (std::size_t s = 0; s < 2; ++s) {
    const CornerSide& side = one.corner.sides[s];
    if (across.norm() < kNear * side.extent &&
        across.dot(side.direction) > kAlong * across.norm()) {
      return s;
    }
  }
  return std::nullopt;
}

/// Which of some corners have another like them, a facet away, on either side.
std::vector<bool> in_the_middle_of_rows(const std::vector<HeldCorner>& corners,
                                        const std::vector<std::size_t>& some,
                                        const std::vector<std::size_t>& all) {
  std::vector<bool> result(corners.size(), false);
  for (const std::size_t k : some) {
    std::array<bool, 2> is_there{};
    for (const std::size_t other : all) {
      if (other == k) continue;
      const auto side = side_of_next(corners[k], corners[other]);
      if (side) is_there[*side] = true;
    }
    result[k] = is_there[0] && is_there[1];
  }
  return result;
}

/// Whether a face at a corner bends as the corner does, and many times as much:
/// then the corner is what a polynomial leaves of a curve that it follows. A
/// parabola over an arc of θ is θ³/32 off at its ends; with its middle node
/// off, as meshers leave it to keep cells from folding, up to a quarter of θ
/// was seen.
bool is_left_of_curve(const HeldCorner& at) {
  constexpr double kOfTurn = 0.25;
  const double sense = *at.kink > 0.0 ? 1.0 : -1.0;
  return std::ranges::any_of(at.corner.sides, [&](const CornerSide& side) {
    return std::abs(*at.kink) < kOfTurn * sense * side.turn;
  });
}

/// How much of a stress a kink disturbs: what flows from one side to the other,
/// and what shears along the edge [1].
double share_across(const BoundaryCorner& corner,
                    const Eigen::Matrix3d& stress) {
  if (stress.isZero()) return 1.0;
  const Vector3d across =
      (corner.sides[0].direction - corner.sides[1].direction).normalized();
  const Eigen::Matrix3d deviator =
      stress - stress.trace() / 3.0 * Eigen::Matrix3d::Identity();
  const double von_mises = std::sqrt(1.5) * deviator.norm();
  const double normal = std::abs(across.dot(stress * across));
  const double shear = std::abs(corner.axis.dot(stress * across));
  return std::min(1.0, std::hypot(normal, std::sqrt(3.0) * shear) / von_mises);
}

/// Whether a corner's edge goes round the axis: it is one of the section.
bool goes_round(const BoundaryCorner& corner, const mesh::Revolution& turned) {
  const Vector3d round =
      turned.axes.col(0).cross(corner.at - turned.origin).normalized();
  return std::abs(corner.axis.dot(round)) > std::numbers::sqrt2 / 2.0;
}

}  // namespace

std::vector<bool> facets_of_curves(const std::vector<HeldCorner>& corners) {
  std::vector<std::size_t> small, large, all;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto& kink = corners[k].kink;
    const double size = kink ? std::abs(*kink) : 0.0;
    if (!(size > 1e-6 && size < kFacetKink / 180.0 * kPi)) continue;
    all.push_back(k);
    (size < kSmallKink / 180.0 * kPi ? small : large).push_back(k);
  }
  std::vector<bool> result(corners.size(), false);
  for (const std::size_t k : small) {
    result[k] = is_left_of_curve(corners[k]) ||
                std::ranges::any_of(small, [&](std::size_t other) {
                  return other != k && turn_alike(corners[k], corners[other]);
                });
  }
  const auto is_middle = in_the_middle_of_rows(corners, large, all);
  for (const std::size_t k : large) {
    result[k] = is_middle[k] || std::ranges::any_of(large, [&](std::size_t o) {
                  return is_middle[o] && side_of_next(corners[k], corners[o]);
                });
  }
  return result;
}

double facet_kink(const mesh::PartMesh<3>& mesh, const part::Supports& fixed,
                  const Vector3d& at, const Eigen::Matrix3d& stress,
                  const mesh::Revolution* turned) {
  const auto corners = held_corners<3>(mesh, fixed);
  const auto is_facet = facets_of_curves(corners);
  double largest = 0.0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    if (!is_facet[k]) continue;
    const BoundaryCorner& corner = corners[k].corner;
    if (turned && !goes_round(corner, *turned)) continue;
    const Vector3d arm = at - corner.at;
    const double across = (arm - corner.axis.dot(arm) * corner.axis).norm();
    if (arm.norm() > 2.0 * corner.reach || across > corner.reach) continue;
    largest = std::max(
        largest, std::abs(*corners[k].kink) * share_across(corner, stress));
  }
  return largest;
}

}  // namespace clevis::stress
