#include "stress/zones/singular_zone.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <tuple>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "mesh/cells/topology.h"
#include "part/supports.h"
#include "stress/corners/boundary_corner.h"
#include "stress/corners/facet.h"
#include "stress/corners/held_corner.h"
#include "stress/corners/round_surfaces.h"
#include "stress/corners/wall.h"
#include "stress/corners/wedge_exponent.h"
#include "stress/zones/end_of_shear.h"

namespace clevis::stress {
namespace {

using Eigen::Vector3d;
using Hold = WedgeSide::Hold;

constexpr double kPi = std::numbers::pi;
/// Over straight, of sides held alike: λ = 0.95, a tenth more stress where the
/// distance falls to a tenth [degrees].
constexpr double kSmallestNotch = 4.7;
constexpr double kRadiusOfWay = 0.5;
constexpr double kNearlyWhole = 355.0 / 180.0 * kPi;  // a crack

/// Exponents of corners, each kind computed once.
class Exponents {
 public:
  Exponents(double kolosov, bool solid) : kolosov_(kolosov), solid_(solid) {}

  /// @param is_facet  the corner is one of a curve.
  double smallest(const HeldCorner& at, bool is_facet) {
    // Free, the exponent is above kSmoothExponent: 1 − 2δ/(π + 2δ).
    constexpr double kNone = kSmallestNotch / 180.0 * kPi;
    const double angle = at.corner.angle;
    const auto& [first, second] = at.held;
    double result = 1.0;
    if (!is_facet && !(at.kink && *at.kink < kNone)) {
      result = in_plane(angle, first.wedge, second.wedge);
    }
    const bool smooth_antiplane = first.along_axis == second.along_axis &&
                                  (is_facet || angle < kPi + kNone);
    if (solid_ && !smooth_antiplane) {
      result = std::min(result, antiplane_exponent(angle, first.along_axis,
                                                   second.along_axis));
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
      const auto all =
          wedge_exponents(std::min(angle, 2.0 * kPi), first, second, kolosov_);
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
  std::string kind;     // "edge of root", "notch"
  std::string edge_of;  // the group that holds one side; empty: none or both
  double rise{};        // see SingularZone
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
                                  const std::vector<HeldCorner>& corners,
                                  const std::vector<bool>& is_facet,
                                  const loads::SurfaceShear& shear) {
  const double nu = material.poissons_ratio;
  Exponents exponents(
      dim == 2 ? kolosov_plane_stress(nu) : kolosov_plane_strain(nu), dim == 3);
  std::vector<Candidate> result;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto& [corner, held, name, kink] = corners[k];
    const double exponent = exponents.smallest(corners[k], is_facet[k]);
    if (exponent > kSmoothExponent) {
      if (const auto end = end_of_shear<dim>(mesh, corners[k], shear)) {
        result.push_back(
            {corner, 1.0, "end of the shear on " + end->group, "", end->rise});
      }
      continue;
    }
    result.push_back(
        {corner, exponent, kind_of(corner.angle, name[0], name[1]),
         name[0].empty() || name[1].empty() ? name[0] + name[1] : ""});
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

/// Way from a zone to the nearest curve that it does not touch: what
/// concentrates stress of its own is not left out with it.
double way_to_round(const SingularZone& zone,
                    const std::vector<RoundSurface>& rounds) {
  double nearest = std::numeric_limits<double>::max();
  for (const RoundSurface& round : rounds) {
    if (std::ranges::any_of(zone.vertices, [&](unsigned v) {
          return round.vertices.contains(v);
        })) {
      continue;
    }
    for (const Vector3d& point : round.points) {
      nearest = std::min(nearest, distance(zone, point));
    }
  }
  return nearest;
}

/// A point of a hollow surface, and how far the next may be [m].
struct HollowPoint {
  Vector3d at;
  double reach{};
};

/// Of grooves, notches and fillets, whatever group they are in.
std::vector<HollowPoint> hollow_points(const std::vector<HeldCorner>& corners,
                                       const std::vector<bool>& is_facet) {
  constexpr double kBends = 0.087;  // a face by 5°
  constexpr double kNext = 1.2;     // facets of curved cells bend a little
  std::vector<HollowPoint> points;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto& [corner, held, name, kink] = corners[k];
    const bool is_hollow =
        (is_facet[k] && *kink > 0.0) ||
        std::ranges::any_of(corner.sides, [](const CornerSide& side) {
          return side.turn > kBends;
        });
    if (!is_hollow) continue;
    points.push_back({corner.at, kNext * std::max(corner.sides[0].extent,
                                                  corner.sides[1].extent)});
  }
  return points;
}

/// The same way to the nearest hollow surface that does not begin at the zone,
/// if it is less than `most` [m].
double way_to_hollow(const SingularZone& zone,
                     const std::vector<HollowPoint>& points, double most) {
  std::vector<HollowPoint> near, joined;
  for (const HollowPoint& point : points) {
    const double way = distance(zone, point.at);
    if (way >= most) continue;
    (way <= point.reach ? joined : near).push_back(point);
  }
  while (!joined.empty()) {
    const HollowPoint from = joined.back();
    joined.pop_back();
    const auto next =
        std::partition(near.begin(), near.end(), [&](const HollowPoint& point) {
          return (point.at - from.at).norm() >
                 std::max(point.reach, from.reach);
        });
    joined.insert(joined.end(), next, near.end());
    near.erase(next, near.end());
  }
  for (const HollowPoint& point : near) {
    most = std::min(most, distance(zone, point.at));
  }
  return most;
}

/// Digits after the point of places [mm]: one of parts from 10 mm on, and as
/// many more as a smaller part needs to tell its corners apart.
template <int dim>
int decimals(const mesh::PartMesh<dim>& mesh) {
  constexpr int kMost = 6;
  Eigen::AlignedBox<double, dim> box;
  for (const auto& vertex : mesh.vertices) box.extend(vertex);
  const double size = 1e3 * box.diagonal().norm();  // [mm]
  if (!(size > 0.0)) return 1;
  return std::clamp(2 - static_cast<int>(std::floor(std::log10(size))), 1,
                    kMost);
}

template <int dim>
std::string name_of(const std::string& kind, const Vector3d& at, int digits) {
  const double steps = std::pow(10.0, digits);  // adding zero turns -0 into 0
  const Vector3d mm = (at * 1e3 * steps).array().round() / steps + 0.0;
  return dim == 2 ? fmt::format("{} at ({:.{}f}, {:.{}f}) mm", kind, mm.x(),
                                digits, mm.y(), digits)
                  : fmt::format("{} at ({:.{}f}, {:.{}f}, {:.{}f}) mm", kind,
                                mm.x(), digits, mm.y(), digits, mm.z(), digits);
}

template <int dim>
SingularZone make_zone(const mesh::PartMesh<dim>& mesh,
                       const std::vector<RoundSurface>& rounds,
                       const std::vector<HollowPoint>& hollows, int digits,
                       const std::vector<const Candidate*>& members) {
  SingularZone zone;
  const Candidate& middle = *members[members.size() / 2];
  zone.exponent = 1.0;
  zone.edge_of = middle.edge_of;
  zone.at = middle.corner.at;
  double wall = std::numeric_limits<double>::max();
  for (const Candidate* member : members) {
    const BoundaryCorner& corner = member->corner;
    zone.exponent = std::min(zone.exponent, member->exponent);
    zone.rise = std::max(zone.rise, member->rise);
    zone.edges.emplace_back(position(mesh, corner.vertices[0]),
                            position(mesh, corner.vertices[1]));
    zone.vertices.insert(zone.vertices.end(), corner.vertices.begin(),
                         corner.vertices.end());
    wall = std::min(wall, wall_thickness_at<dim>(mesh, corner));
    zone.reach = std::max(zone.reach, corner.reach);
  }
  std::ranges::sort(zone.vertices);
  const auto twice = std::ranges::unique(zone.vertices);
  zone.vertices.erase(twice.begin(), twice.end());
  zone.radius =
      std::min(kRadiusOfWall * wall, kRadiusOfWay * way_to_round(zone, rounds));
  zone.radius =
      kRadiusOfWay * way_to_hollow(zone, hollows, zone.radius / kRadiusOfWay);
  zone.name = name_of<dim>(middle.kind, zone.at, digits);
  return zone;
}

}  // namespace

template <int dim>
std::vector<SingularZone> singular_zones(const mesh::PartMesh<dim>& mesh,
                                         const part::Material& material,
                                         const part::Supports& fixed,
                                         const loads::SurfaceShear& shear) {
  const auto corners = held_corners<dim>(mesh, fixed);
  const auto is_facet = facets_of_curves(corners);
  const auto all = candidates<dim>(mesh, material, corners, is_facet, shear);
  const auto root = connected(all);
  std::map<std::size_t, std::vector<const Candidate*>> chains;
  for (std::size_t k = 0; k < all.size(); ++k) {
    chains[root[k]].push_back(&all[k]);
  }
  std::vector<SingularZone> zones;
  const int digits = decimals<dim>(mesh);
  const auto rounds = round_surfaces(mesh);
  const auto hollows = all.empty() ? std::vector<HollowPoint>()
                                   : hollow_points(corners, is_facet);
  for (const auto& [first, members] : chains) {
    zones.push_back(make_zone<dim>(mesh, rounds, hollows, digits, members));
  }
  return zones;
}

double distance(const SingularZone& zone, const Vector3d& point) {
  double nearest = std::numeric_limits<double>::max();
  for (const auto& [from, to] : zone.edges) {
    nearest = std::min(nearest, distance_from_edge(point, from, to));
  }
  return nearest;
}

template std::vector<SingularZone> singular_zones<2>(
    const mesh::PartMesh<2>&, const part::Material&, const part::Supports&,
    const loads::SurfaceShear&);
template std::vector<SingularZone> singular_zones<3>(
    const mesh::PartMesh<3>&, const part::Material&, const part::Supports&,
    const loads::SurfaceShear&);

}  // namespace clevis::stress
