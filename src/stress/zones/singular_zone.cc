#include "stress/zones/singular_zone.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <tuple>

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <fmt/format.h>

#include "mesh/cells/topology.h"
#include "part/supports.h"
#include "stress/zones/boundary_corner.h"
#include "stress/zones/round_surfaces.h"
#include "stress/zones/wall.h"
#include "stress/zones/wedge_exponent.h"

namespace clevis::stress {
namespace {

using Eigen::Vector3d;
using Hold = WedgeSide::Hold;

constexpr double kPi = std::numbers::pi;
/// Over straight, of sides held alike: λ = 0.95, a tenth more stress where the
/// distance falls to a tenth [degrees].
constexpr double kSmallestNotch = 4.7;
constexpr double kSmallKink = 15.0;   // degrees
constexpr double kSkewRoller = 15.0;  // degrees
constexpr double kRadiusOfWay = 0.5;
constexpr double kNearlyWhole = 355.0 / 180.0 * kPi;  // a crack

/// Support of a side: in the plane across the corner and along its axis.
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
         std::abs(std::cos(side.direction)) < std::sin(kSkewRoller / 180 * kPi);
}

/// Angle of the material at the corner, of itself or with its mirror image
/// behind a roller; nothing where the sides are held unlike.
std::optional<double> whole_angle(double angle, const WedgeSide& first,
                                  const WedgeSide& second) {
  if (first.hold == second.hold) return angle;
  const bool mirrored = (is_roller(first) && second.hold == Hold::kNothing) ||
                        (is_roller(second) && first.hold == Hold::kNothing);
  if (mirrored) return 2.0 * angle;
  return std::nullopt;
}

/// A corner with what is held beside it.
struct HeldCorner {
  BoundaryCorner corner;
  std::array<HeldSide, 2> held;
  std::array<std::string, 2> name;  ///< of the group of a side that holds
  /// Over straight, positive where the corner is re-entrant [rad].
  std::optional<double> kink;
};

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

/// Which corners are those between facets of a curve: kinks of a few degrees
/// beside another like them or a face that bends much more, larger ones in a
/// row of three and more with one facet between each two. Others are notches,
/// however blunt: a groove or a chamfer has two of them.
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

/// Where shear ends on a smooth or re-entrant surface: its candidate, or
/// nothing. The stress goes like the logarithm of the distance, steepest along
/// the shear; what is below a thousandth of a zone's radius, a micrometre or
/// so, is no longer elastic.
template <int dim>
std::optional<Candidate> end_of_shear(const mesh::PartMesh<dim>& mesh,
                                      const BoundaryCorner& corner,
                                      const loads::SurfaceShear& shear) {
  constexpr double kPerFold = 1.10;  // √3 · 2/π
  constexpr double kFolds = 4.6;     // from a tenth of the radius
  if (corner.angle < kBluntEdge) return std::nullopt;
  const auto beside = shear_beside<dim>(mesh, corner, shear);
  if (!beside[0] && !beside[1]) return std::nullopt;
  const double jump = jump_of(beside);
  if (!(jump > 0.0)) return std::nullopt;
  const auto side = static_cast<std::size_t>(beside[0] == nullptr);
  return Candidate{
      corner, 1.0,
      "end of the shear on " +
          mesh.groups[static_cast<std::size_t>(corner.sides[side].group)].name,
      "", kPerFold * kFolds * jump};
}

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
std::vector<HeldCorner> held_corners(const mesh::PartMesh<dim>& mesh,
                                     const part::Supports& fixed) {
  std::vector<HeldCorner> result;
  for (const BoundaryCorner& corner : boundary_corners<dim>(mesh)) {
    HeldCorner& entry = result.emplace_back();
    entry.corner = corner;
    for (std::size_t s = 0; s < 2; ++s) {
      const int group = corner.sides[s].group;
      if (group < 0) continue;
      const auto found =
          fixed.find(mesh.groups[static_cast<std::size_t>(group)].name);
      if (found == fixed.end()) continue;
      auto components = found->second;
      if (dim == 2) components[2] = false;
      entry.held[s] = held_side(corner, corner.sides[s], components);
      if (std::ranges::count(components, true) > 0) {
        entry.name[s] = found->first;
      }
    }
    const auto angle =
        whole_angle(corner.angle, entry.held[0].wedge, entry.held[1].wedge);
    if (angle) entry.kink = *angle - kPi;
  }
  return result;
}

template <int dim>
std::vector<Candidate> candidates(const mesh::PartMesh<dim>& mesh,
                                  const part::Material& material,
                                  const part::Supports& fixed,
                                  const loads::SurfaceShear& shear) {
  const double nu = material.poissons_ratio;
  Exponents exponents(
      dim == 2 ? kolosov_plane_stress(nu) : kolosov_plane_strain(nu), dim == 3);
  const auto corners = held_corners<dim>(mesh, fixed);
  const auto is_facet = facets_of_curves(corners);
  std::vector<Candidate> result;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto& [corner, held, name, kink] = corners[k];
    const double exponent = exponents.smallest(corners[k], is_facet[k]);
    if (exponent > kSmoothExponent) {
      if (auto end = end_of_shear<dim>(mesh, corner, shear)) {
        result.push_back(std::move(*end));
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

template <int dim>
SingularZone make_zone(const mesh::PartMesh<dim>& mesh,
                       const std::vector<RoundSurface>& rounds,
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
  const Vector3d mm = (zone.at * 1e4).array().round() / 10.0 + 0.0;
  zone.name = dim == 2 ? fmt::format("{} at ({:.1f}, {:.1f}) mm", middle.kind,
                                     mm.x(), mm.y())
                       : fmt::format("{} at ({:.1f}, {:.1f}, {:.1f}) mm",
                                     middle.kind, mm.x(), mm.y(), mm.z());
  return zone;
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

template <int dim>
std::vector<SingularZone> singular_zones(const mesh::PartMesh<dim>& mesh,
                                         const part::Material& material,
                                         const part::Supports& fixed,
                                         const loads::SurfaceShear& shear) {
  const auto all = candidates<dim>(mesh, material, fixed, shear);
  const auto root = connected(all);
  std::map<std::size_t, std::vector<const Candidate*>> chains;
  for (std::size_t k = 0; k < all.size(); ++k) {
    chains[root[k]].push_back(&all[k]);
  }
  std::vector<SingularZone> zones;
  const auto rounds = round_surfaces(mesh);
  for (const auto& [first, members] : chains) {
    zones.push_back(make_zone<dim>(mesh, rounds, members));
  }
  return zones;
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

double rise_at_edges(const mesh::PartMesh<3>& mesh,
                     const loads::SurfaceShear& shear, const Vector3d& at) {
  double largest = 0.0;
  if (shear.empty()) return largest;
  for (const BoundaryCorner& corner : boundary_corners<3>(mesh)) {
    const Vector3d arm = at - corner.at;
    const double half = 0.5 * (position(mesh, corner.vertices[0]) -
                               position(mesh, corner.vertices[1]))
                                  .norm();
    const double along = std::abs(corner.axis.dot(arm));
    const double across = (arm - corner.axis.dot(arm) * corner.axis).norm();
    if (corner.angle >= kBluntEdge || across > corner.reach ||
        along > half + corner.reach) {
      continue;
    }
    const auto beside = shear_beside<3>(mesh, corner, shear);
    if (!beside[0] && !beside[1]) continue;
    // What points to the edge has to meet its like on the other face.
    Eigen::VectorXd rest;
    for (std::size_t s = 0; s < 2; ++s) {
      if (!beside[s]) continue;
      const Eigen::VectorXd towards = (s == 0 ? 1.0 : -1.0) *
                                      beside[s]->even.transpose() *
                                      corner.sides[s].direction;
      rest = rest.size() == 0 ? towards : Eigen::VectorXd(rest + towards);
    }
    largest = std::max(largest, rest.lpNorm<Eigen::Infinity>());
  }
  return 0.5 * kPi * largest;
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

template std::vector<SingularZone> singular_zones<2>(
    const mesh::PartMesh<2>&, const part::Material&, const part::Supports&,
    const loads::SurfaceShear&);
template std::vector<SingularZone> singular_zones<3>(
    const mesh::PartMesh<3>&, const part::Material&, const part::Supports&,
    const loads::SurfaceShear&);

}  // namespace clevis::stress
