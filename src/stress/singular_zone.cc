#include "stress/singular_zone.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <tuple>

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <fmt/format.h>

#include "elasticity/wedge_exponent.h"
#include "stress/boundary_corner.h"
#include "stress/wall.h"

namespace clevis::stress {
namespace {

using Eigen::Vector3d;
using elasticity::WedgeSide;
using Hold = WedgeSide::Hold;

constexpr double kPi = std::numbers::pi;
constexpr double kNearlyWhole = 355.0 / 180.0 * kPi;  // a crack

/// What holds a side: in the plane across the corner and along its axis.
struct HeldSide {
  WedgeSide wedge;
  bool along_axis{};
};

/// @param held  components of the group of that side.
HeldSide held_side(const BoundaryCorner& corner, const CornerSide& side,
                   const std::array<bool, 3>& held) {
  constexpr double kCounts = 0.5;  // of a unit component
  Eigen::Matrix3d components = Eigen::Matrix3d::Zero();
  for (int d = 0; d < 3; ++d) {
    if (held[static_cast<std::size_t>(d)]) {
      components.col(d) = Vector3d::Unit(d);
    }
  }
  const Vector3d across = corner.axis.cross(side.direction);
  Eigen::Matrix<double, 2, 3> in_plane;
  in_plane << side.direction.transpose() * components,
      across.transpose() * components;
  const Eigen::JacobiSVD<Eigen::Matrix<double, 2, 3>> svd(in_plane,
                                                          Eigen::ComputeFullU);
  HeldSide result;
  result.along_axis = (corner.axis.transpose() * components).norm() > kCounts;
  if (svd.singularValues()[1] > kCounts) {
    result.wedge.hold = Hold::kBoth;
  } else if (svd.singularValues()[0] > kCounts) {
    result.wedge.hold = Hold::kOneDirection;
    const Eigen::Vector2d u = svd.matrixU().col(0);
    result.wedge.direction = std::atan2(u[1], u[0]);
  }
  return result;
}

bool is_roller(const WedgeSide& side) {
  return side.hold == Hold::kOneDirection &&
         std::abs(std::cos(side.direction)) < std::sin(kSmoothKink / 180 * kPi);
}

/// Whether the corner is a small kink, of itself or with its mirror image
/// behind a roller.
bool is_kink(double angle, const WedgeSide& first, const WedgeSide& second) {
  const double straight = kPi + kSmoothKink / 180.0 * kPi;
  if (first.hold == second.hold) return angle < straight;
  const bool mirrored = (is_roller(first) && second.hold == Hold::kNothing) ||
                        (is_roller(second) && first.hold == Hold::kNothing);
  return mirrored && 2.0 * angle < straight;
}

/// Exponents of corners, each kind computed once.
class Exponents {
 public:
  Exponents(double kolosov, bool solid) : kolosov_(kolosov), solid_(solid) {}

  double smallest(double angle, const HeldSide& first, const HeldSide& second) {
    double result = 1.0;
    if (!is_kink(angle, first.wedge, second.wedge)) {
      result = in_plane(angle, first.wedge, second.wedge);
    }
    const bool antiplane_kink = first.along_axis == second.along_axis &&
                                angle < kPi + kSmoothKink / 180.0 * kPi;
    if (solid_ && !antiplane_kink) {
      result =
          std::min(result, elasticity::antiplane_exponent(
                               angle, first.along_axis, second.along_axis));
    }
    return result;
  }

 private:
  double in_plane(double angle, const WedgeSide& first,
                  const WedgeSide& second) {
    const auto rounded = [](double value) {
      return std::lround(value * 1e5);
    };
    const auto key =
        std::tuple(rounded(angle), first.hold, rounded(first.direction),
                   second.hold, rounded(second.direction));
    const auto [entry, is_new] = known_.emplace(key, 1.0);
    if (is_new) {
      const auto all = elasticity::wedge_exponents(std::min(angle, 2.0 * kPi),
                                                   first, second, kolosov_);
      if (!all.empty()) entry->second = all.front();
    }
    return entry->second;
  }

  double kolosov_;
  bool solid_;
  std::map<std::tuple<long, Hold, long, Hold, long>, double> known_;
};

/// A singular corner with what names it.
struct Candidate {
  BoundaryCorner corner;
  double exponent{};
  std::string kind;  // "edge of root", "notch"
};

/// Names of the groups on both sides that hold something.
std::string kind_of(double angle, const std::string& first,
                    const std::string& second) {
  if (first.empty() && second.empty()) {
    return angle > kNearlyWhole ? "crack" : "notch";
  }
  if (first == second) return "notch in " + first;
  if (first.empty() || second.empty()) return "edge of " + first + second;
  return "edge between " + std::min(first, second) + " and " +
         std::max(first, second);
}

template <int dim>
std::vector<Candidate> candidates(const mesh::PartMesh<dim>& mesh,
                                  const part::Material& material,
                                  const FixedGroups& fixed) {
  const double nu = material.poissons_ratio;
  Exponents exponents(dim == 2 ? elasticity::kolosov_plane_stress(nu)
                               : elasticity::kolosov_plane_strain(nu),
                      dim == 3);
  std::vector<Candidate> result;
  for (const BoundaryCorner& corner : boundary_corners<dim>(mesh)) {
    std::array<HeldSide, 2> held;
    std::array<std::string, 2> name;
    for (std::size_t s = 0; s < 2; ++s) {
      const int group = corner.sides[s].group;
      if (group < 0) continue;
      const auto entry =
          fixed.find(mesh.groups[static_cast<std::size_t>(group)].name);
      if (entry == fixed.end()) continue;
      auto components = entry->second;
      if (dim == 2) components[2] = false;
      held[s] = held_side(corner, corner.sides[s], components);
      if (std::ranges::count(components, true) > 0) name[s] = entry->first;
    }
    const double exponent = exponents.smallest(corner.angle, held[0], held[1]);
    if (exponent > kSmoothExponent) continue;
    result.push_back(
        {corner, exponent, kind_of(corner.angle, name[0], name[1])});
  }
  return result;
}

/// Numbers candidates of one kind that hang together by their vertices.
std::vector<std::size_t> connected(const std::vector<Candidate>& all) {
  std::vector<std::size_t> root(all.size());
  std::iota(root.begin(), root.end(), 0U);
  const auto find = [&](std::size_t k) {
    while (root[k] != k) k = root[k] = root[root[k]];
    return k;
  };
  std::map<std::pair<unsigned, std::string>, std::size_t> seen;
  for (std::size_t k = 0; k < all.size(); ++k) {
    for (const unsigned vertex : all[k].corner.vertices) {
      const auto [entry, is_new] =
          seen.emplace(std::pair(vertex, all[k].kind), k);
      if (!is_new) root[find(k)] = find(entry->second);
    }
  }
  for (std::size_t k = 0; k < all.size(); ++k) root[k] = find(k);
  return root;
}

template <int dim>
Vector3d in_space(const mesh::PartMesh<dim>& mesh, unsigned vertex) {
  Vector3d result(0.0, 0.0, mesh.mid_plane_z);
  result.head<dim>() = mesh.vertices[vertex];
  return result;
}

template <int dim>
SingularZone make_zone(const mesh::PartMesh<dim>& mesh,
                       const std::vector<const Candidate*>& members) {
  SingularZone zone;
  const Candidate& middle = *members[members.size() / 2];
  zone.exponent = 1.0;
  zone.at = middle.corner.at;
  double wall = std::numeric_limits<double>::max();
  double reach = 0.0;
  for (const Candidate* member : members) {
    const BoundaryCorner& corner = member->corner;
    zone.exponent = std::min(zone.exponent, member->exponent);
    zone.edges.emplace_back(in_space(mesh, corner.vertices[0]),
                            in_space(mesh, corner.vertices[1]));
    zone.vertices.insert(zone.vertices.end(), corner.vertices.begin(),
                         corner.vertices.end());
    wall = std::min(wall, wall_behind<dim>(mesh, corner));
    reach = std::max(reach, corner.reach);
  }
  std::ranges::sort(zone.vertices);
  const auto twice = std::ranges::unique(zone.vertices);
  zone.vertices.erase(twice.begin(), twice.end());
  zone.radius = kRadiusOfWall * wall;
  if (dim == 3) zone.radius = std::max(zone.radius, reach);
  const Vector3d mm = (zone.at * 1e4).array().round() / 10.0 + 0.0;
  zone.name = dim == 2 ? fmt::format("{} at ({:.1f}, {:.1f}) mm", middle.kind,
                                     mm.x(), mm.y())
                       : fmt::format("{} at ({:.1f}, {:.1f}, {:.1f}) mm",
                                     middle.kind, mm.x(), mm.y(), mm.z());
  return zone;
}

}  // namespace

template <int dim>
std::vector<SingularZone> singular_zones(const mesh::PartMesh<dim>& mesh,
                                         const part::Material& material,
                                         const FixedGroups& fixed) {
  const auto all = candidates<dim>(mesh, material, fixed);
  const auto root = connected(all);
  std::map<std::size_t, std::vector<const Candidate*>> chains;
  for (std::size_t k = 0; k < all.size(); ++k) {
    chains[root[k]].push_back(&all[k]);
  }
  std::vector<SingularZone> zones;
  for (const auto& [first, members] : chains) {
    zones.push_back(make_zone<dim>(mesh, members));
  }
  return zones;
}

double distance(const SingularZone& zone, const Vector3d& point) {
  double nearest = std::numeric_limits<double>::max();
  for (const auto& [from, to] : zone.edges) {
    const Vector3d along = to - from;
    const double square = along.squaredNorm();
    const double t =
        square > 0.0 ? std::clamp((point - from).dot(along) / square, 0.0, 1.0)
                     : 0.0;
    nearest = std::min(nearest, (point - from - t * along).norm());
  }
  return nearest;
}

template std::vector<SingularZone> singular_zones<2>(const mesh::PartMesh<2>&,
                                                     const part::Material&,
                                                     const FixedGroups&);
template std::vector<SingularZone> singular_zones<3>(const mesh::PartMesh<3>&,
                                                     const part::Material&,
                                                     const FixedGroups&);

}  // namespace clevis::stress
