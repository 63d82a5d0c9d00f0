#include "stress/zones/end_of_shear.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "mesh/cells/topology.h"
#include "stress/corners/round_surfaces.h"

namespace clevis::stress {
namespace {

using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;

// Below this angle of the material shear that ends leaves a bounded stress.
constexpr double kBluntEdge = 0.75 * kPi;

/// Shear on both sides of a corner; null where there is none.
template <int dim>
std::array<const loads::GroupShear*, 2> shear_beside(
    const mesh::PartMesh<dim>& mesh, const BoundaryCorner& corner,
    const loads::SurfaceShear& shear) {
  std::array<const loads::GroupShear*, 2> beside{};
  if (corner.sides[0].group == corner.sides[1].group) return beside;
  for (std::size_t s = 0; s < 2; ++s) {
    const int group = corner.sides[s].group;
    if (group < 0) continue;
    const auto found =
        shear.find(mesh.groups[static_cast<std::size_t>(group)].name);
    if (found != shear.end()) beside[s] = &found->second;
  }
  return beside;
}

/// Largest jump of the shear over a smooth edge, of all instants [Pa].
double jump_of(const std::array<const loads::GroupShear*, 2>& beside) {
  const loads::GroupShear& first = beside[0] ? *beside[0] : *beside[1];
  if (!beside[0] || !beside[1]) {
    return (first.even.colwise().norm().transpose() + first.turning).maxCoeff();
  }
  return ((first.even - beside[1]->even).colwise().norm().transpose() +
          first.turning + beside[1]->turning)
      .maxCoeff();
}

/// The same at a roller, which mirrors what runs towards it and leaves on what
/// runs along it [Pa].
double jump_of_mirrored(const BoundaryCorner& corner,
                        const std::array<const loads::GroupShear*, 2>& beside) {
  double largest = 0.0;
  for (std::size_t s = 0; s < 2; ++s) {
    if (!beside[s]) continue;
    const Eigen::VectorXd towards =
        beside[s]->even.transpose() * corner.sides[s].direction;
    largest = std::max(
        largest, 2.0 * (towards.cwiseAbs() + beside[s]->turning).maxCoeff());
  }
  return largest;
}

}  // namespace

template <int dim>
std::optional<EndOfShear> end_of_shear(const mesh::PartMesh<dim>& mesh,
                                       const HeldCorner& at,
                                       const loads::SurfaceShear& shear) {
  constexpr double kPerFold = 1.10;  // √3 · 2/π
  constexpr double kFolds = 4.6;     // from a tenth of the radius
  const BoundaryCorner& corner = at.corner;
  const bool is_mirrored = at.held[0].wedge.hold != at.held[1].wedge.hold;
  const double angle = is_mirrored && at.kink ? *at.kink + kPi : corner.angle;
  if (angle < kBluntEdge) return std::nullopt;
  const auto beside = shear_beside<dim>(mesh, corner, shear);
  if (!beside[0] && !beside[1]) return std::nullopt;
  const double jump =
      is_mirrored ? jump_of_mirrored(corner, beside) : jump_of(beside);
  if (!(jump > 0.0)) return std::nullopt;
  const auto side = static_cast<std::size_t>(beside[0] == nullptr);
  return EndOfShear{
      mesh.groups[static_cast<std::size_t>(corner.sides[side].group)].name,
      kPerFold * kFolds * jump};
}

double SharpEnd::rise_beside(const Vector3d& point) const {
  constexpr double kEnds = 1.001;
  const Vector3d arm = point - at;
  const double along = axis.dot(arm);
  if (std::abs(along) > kEnds * half || (arm - along * axis).norm() > reach) {
    return 0.0;
  }
  const double share = std::clamp(0.5 * (1.0 + along / half), 0.0, 1.0);
  return (1.0 - share) * rise[0] + share * rise[1];
}

namespace {

/// π/2 of what points to the edge and does not meet its like on the other face,
/// the most of all instants, at a point of the edge [Pa].
double rise_at(const BoundaryCorner& corner,
               const std::array<const loads::GroupShear*, 2>& beside,
               const Vector3d& point) {
  Eigen::VectorXd rest;
  for (std::size_t s = 0; s < 2; ++s) {
    if (!beside[s]) continue;
    const Eigen::VectorXd towards = (s == 0 ? 1.0 : -1.0) *
                                    beside[s]->at(point).transpose() *
                                    corner.sides[s].direction;
    rest = rest.size() == 0 ? towards : Eigen::VectorXd(rest + towards);
  }
  return 0.5 * kPi * rest.lpNorm<Eigen::Infinity>();
}

/// By vertex, the edges that meet there.
std::map<unsigned, std::vector<const SharpEnd*>> by_vertex(
    const std::vector<SharpEnd>& ends) {
  std::map<unsigned, std::vector<const SharpEnd*>> at;
  for (const SharpEnd& end : ends) {
    for (const unsigned vertex : end.vertices) at[vertex].push_back(&end);
  }
  return at;
}

/// Whether two edges that meet are facets of a rim: they turn, by less than a
/// corner.
bool are_of_a_curve(const SharpEnd& one, const SharpEnd& other) {
  constexpr double kStraight = 0.99985, kCorner = 0.766;  // 1°, 40°
  const double turn = std::abs(one.axis.dot(other.axis));
  return turn < kStraight && turn > kCorner;
}

}  // namespace

std::vector<SharpEnd> sharp_ends(const mesh::PartMesh<3>& mesh,
                                 const loads::SurfaceShear& shear) {
  std::vector<SharpEnd> ends;
  std::vector<double> in_the_middle;
  if (shear.empty()) return ends;
  for (const BoundaryCorner& corner : boundary_corners<3>(mesh)) {
    if (corner.angle >= kBluntEdge) continue;
    const auto beside = shear_beside<3>(mesh, corner, shear);
    if (!beside[0] && !beside[1]) continue;
    std::array<unsigned, 2> vertices = corner.vertices;
    if (corner.axis.dot(position(mesh, vertices[1]) -
                        position(mesh, vertices[0])) < 0.0) {
      std::swap(vertices[0], vertices[1]);
    }
    const std::array<Vector3d, 2> at{position(mesh, vertices[0]),
                                     position(mesh, vertices[1])};
    ends.push_back(
        {corner.at,
         corner.axis,
         0.5 * (at[1] - at[0]).norm(),
         corner.reach,
         vertices,
         {rise_at(corner, beside, at[0]), rise_at(corner, beside, at[1])}});
    in_the_middle.push_back(rise_at(corner, beside, corner.at));
  }
  // A facet's direction is that of its rim in its middle alone.
  const auto meeting = by_vertex(ends);
  std::vector<std::array<double, 2>> rises;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    rises.push_back(ends[k].rise);
    for (std::size_t side = 0; side < 2; ++side) {
      if (std::ranges::any_of(meeting.at(ends[k].vertices[side]),
                              [&](const SharpEnd* other) {
                                return are_of_a_curve(ends[k], *other);
                              })) {
        rises.back()[side] = in_the_middle[k];
      }
    }
  }
  for (std::size_t k = 0; k < ends.size(); ++k) ends[k].rise = rises[k];
  return ends;
}

double rise_beside(const std::vector<SharpEnd>& ends, const Vector3d& point) {
  double largest = 0.0;
  for (const SharpEnd& end : ends) {
    largest = std::max(largest, end.rise_beside(point));
  }
  return largest;
}

double stress_at_corners(const std::vector<SharpEnd>& ends) {
  constexpr double kParallel = 0.9;
  constexpr double kOfSum = 1.2;  // the corner's own share, an estimate
  double largest = 0.0;
  for (const auto& [vertex, meeting] : by_vertex(ends)) {
    const auto rise = [&](const SharpEnd& end) {
      return end.rise[end.vertices[0] == vertex ? 0 : 1];
    };
    for (const SharpEnd* one : meeting) {
      for (const SharpEnd* other : meeting) {
        if (std::abs(one->axis.dot(other->axis)) > kParallel) continue;
        largest = std::max(largest, rise(*one) + rise(*other));
      }
    }
  }
  return kOfSum * largest;
}

template std::optional<EndOfShear> end_of_shear<2>(const mesh::PartMesh<2>&,
                                                   const HeldCorner&,
                                                   const loads::SurfaceShear&);
template std::optional<EndOfShear> end_of_shear<3>(const mesh::PartMesh<3>&,
                                                   const HeldCorner&,
                                                   const loads::SurfaceShear&);

}  // namespace clevis::stress
