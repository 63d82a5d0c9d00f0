#include "mesh/rounds/faceted_rounds.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include <Eigen/Dense>
#include <fmt/format.h>

#include "mesh/rounds/cylinder_fit.h"
#include "mesh/rounds/tangent_cylinder.h"

namespace clevis::mesh {

namespace {

using Eigen::Index;
using Eigen::Vector3d;
using Edge = std::pair<unsigned, unsigned>;

constexpr double kDegree = std::numbers::pi / 180.0;
// Between the faces of a rim; a coarse hole's own kink by less.
constexpr double kSharp = 35.0 * kDegree;
constexpr double kSharpOfHole = 60.0 * kDegree;
constexpr double kLargestTurn = 22.7 * kDegree;
constexpr double kLargestTurnOfHole = 51.5 * kDegree;
constexpr double kSpanOfTurn = 1.6;  // a facet's, of staggered rows
constexpr double kSmallestTurn = 0.05 * kDegree;
constexpr double kShortest = 44.0 * kDegree;  // arc
constexpr double kWhole = 359.0 * kDegree;
constexpr double kOnCircle = 1e-5;  // of its radius
constexpr std::size_t kFewest = 5;  // vertices on an arc

struct Facet {
  std::vector<unsigned> cycle;
  Vector3d normal;  ///< unit, outwards or inwards: of the cycle
};

/// A circle in space through the vertices of a rim.
struct Circle {
  Vector3d centre, normal;
  double radius{};
};

std::optional<Circle> circle_through(const Vector3d& a, const Vector3d& b,
                                     const Vector3d& c) {
  const Vector3d u = b - a, v = c - a;
  const Vector3d w = u.cross(v);
  const double sine = w.norm() / (u.norm() * v.norm());
  if (!(sine > 0.1 * kSmallestTurn)) return std::nullopt;
  const Vector3d to_centre =
      (v.squaredNorm() * w.cross(u) - u.squaredNorm() * w.cross(v)) /
      (-2.0 * w.squaredNorm());
  return Circle{a - to_centre, w.normalized(), to_centre.norm()};
}

/// How far a point is off, over the radius.
double distance(const Circle& circle, const Vector3d& p) {
  const Vector3d arm = p - circle.centre;
  const double height = arm.dot(circle.normal);
  const double radius = (arm - height * circle.normal).norm();
  return std::hypot(height, radius - circle.radius) / circle.radius;
}

/// Turn of the way a b c at b, positive about the normal.
double turn(const Vector3d& a, const Vector3d& b, const Vector3d& c,
            const Vector3d& normal) {
  const Vector3d u = b - a, v = c - b;
  return std::atan2(u.cross(v).dot(normal), u.dot(v));
}

class Finder {
 public:
  explicit Finder(const PartMesh<3>& mesh) : mesh_(mesh) {
    for (const BoundaryFace& face : mesh.boundary) {
      const auto cycle = face_cycle(mesh, face);
      facets_.push_back({cycle, area_vector(mesh, cycle).normalized()});
      for (std::size_t i = 0; i < cycle.size(); ++i) {
        sides_[std::minmax(cycle[i], cycle[(i + 1) % cycle.size()])].push_back(
            facets_.size() - 1);
      }
    }
    taken_.assign(facets_.size(), false);
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      const int group = mesh.boundary[f].group;
      taken_[f] =
          group >= 0 && mesh.groups[std::size_t(group)].cylinder.has_value();
    }
  }

  std::vector<FacetedRound> find() {
    std::vector<FacetedRound> rounds;
    for (const bool is_coarse : {false, true}) {
      find_rims(is_coarse ? kSharpOfHole : kSharp);
      const double largest_turn = is_coarse ? kLargestTurnOfHole : kLargestTurn;
      for (const auto& chain : chains()) {
        std::size_t at = 0;
        while (at + kFewest <= chain.size()) {
          const std::size_t end = arc_end(chain, at, largest_turn);
          if (end - at >= kFewest) add(chain, at, end, rounds);
          at = end - at >= kFewest ? end - 1 : at + 1;
        }
      }
    }
    return rounds;
  }

 private:
  const Vector3d& point(unsigned v) const { return mesh_.vertices[v]; }

  void find_rims(double sharp) {
    rim_.clear();
    for (const auto& [edge, sides] : sides_) {
      if (sides.size() != 2) continue;
      const double cosine =
          std::abs(facets_[sides[0]].normal.dot(facets_[sides[1]].normal));
      // Cycles of tetrahedra and hexahedra may run either way.
      if (cosine > std::cos(sharp)) continue;
      rim_[edge.first].push_back(edge.second);
      rim_[edge.second].push_back(edge.first);
    }
  }

  /// Ways along rims through vertices where two edges of it meet; a closed one
  /// goes on for a few vertices past its start, so that no arc is cut there.
  std::vector<std::vector<unsigned>> chains() const {
    std::vector<std::vector<unsigned>> result;
    std::set<Edge> seen;
    const auto walk = [&](unsigned from, unsigned to) {
      std::vector<unsigned> chain = {from, to};
      seen.insert(std::minmax(from, to));
      while (rim_.at(chain.back()).size() == 2 && chain.back() != from) {
        const unsigned here = chain.back(), before = chain[chain.size() - 2];
        const auto& next = rim_.at(here);
        chain.push_back(next[0] == before ? next[1] : next[0]);
        seen.insert(std::minmax(here, chain.back()));
      }
      if (chain.back() == from) {
        const std::size_t once = chain.size() - 1;
        for (std::size_t i = 1; i < once; ++i) chain.push_back(chain[i]);
      }
      return chain;
    };
    for (const bool ends_only : {true, false}) {
      for (const auto& [vertex, others] : rim_) {
        if ((others.size() != 2) != ends_only) continue;
        for (const unsigned other : others) {
          if (seen.contains(std::minmax(vertex, other))) continue;
          result.push_back(walk(vertex, other));
        }
      }
    }
    return result;
  }

  /// Behind the last vertex of the arc that begins at `at`.
  std::size_t arc_end(const std::vector<unsigned>& chain, std::size_t at,
                      double largest_turn) const {
    const auto circle = circle_through(point(chain[at]), point(chain[at + 1]),
                                       point(chain[at + 2]));
    if (!circle) return at;
    std::size_t end = at + 2;
    while (end < chain.size() &&
           goes_on(*circle, point(chain[end - 2]), point(chain[end - 1]),
                   point(chain[end]), largest_turn)) {
      ++end;
    }
    return end;
  }

  /// Whether c follows a and b on the circle, which three vertices near by
  /// determine but roughly: it turns as its chords want.
  static bool goes_on(const Circle& circle, const Vector3d& a,
                      const Vector3d& b, const Vector3d& c,
                      double largest_turn) {
    constexpr double kRoughly = 1e-3;
    constexpr double kOfTurn = 0.02;
    const double angle = turn(a, b, c, circle.normal);
    const double wanted =
        std::asin(std::min(1.0, 0.5 * (b - a).norm() / circle.radius)) +
        std::asin(std::min(1.0, 0.5 * (c - b).norm() / circle.radius));
    return angle > kSmallestTurn && angle < largest_turn &&
           std::abs(angle - wanted) < kOfTurn * wanted &&
           distance(circle, c) < kRoughly;
  }

  void add(const std::vector<unsigned>& chain, std::size_t at, std::size_t end,
           std::vector<FacetedRound>& rounds) {
    // Thirds: a closed rim's last vertex may be its first.
    const std::size_t third = (end - 1 - at) / 3;
    const auto circle =
        circle_through(point(chain[at]), point(chain[at + third]),
                       point(chain[at + 2 * third]));
    if (!circle) return;
    part::Bore cylinder{circle->centre, circle->normal, circle->radius, 0.0};
    snap_axis(cylinder);
    double span = 0.0, largest_turn = 0.0;
    for (std::size_t i = at; i < end; ++i) {
      const Vector3d& p = point(chain[i]);
      if (distance(*circle, p) > kOnCircle) return;
      if (i > at) {
        const double turn =
            std::abs(angle_between(cylinder, point(chain[i - 1]), p));
        span += turn;
        largest_turn = std::max(largest_turn, turn);
      }
    }
    if (span < kShortest) return;
    const bool is_coarse = largest_turn > kLargestTurn;
    if (is_coarse && span < kWhole) return;
    const double widest = std::max(kLargestTurn, kSpanOfTurn * largest_turn);
    FacetedRound round{cylinder, {}};
    std::vector<std::size_t> front;
    for (std::size_t i = at; i + 1 < end; ++i) {
      for (const std::size_t f :
           sides_.at(std::minmax(chain[i], chain[i + 1]))) {
        front.push_back(f);
      }
    }
    std::set<unsigned> corners;
    while (!front.empty()) {
      const std::size_t f = front.back();
      front.pop_back();
      if (taken_[f] || !belongs(facets_[f], cylinder, widest)) continue;
      if (is_coarse && !is_hollow(f, cylinder)) continue;
      taken_[f] = true;
      round.faces.push_back(f);
      const auto& cycle = facets_[f].cycle;
      corners.insert(cycle.begin(), cycle.end());
      for (std::size_t i = 0; i < cycle.size(); ++i) {
        const auto& sides =
            sides_.at(std::minmax(cycle[i], cycle[(i + 1) % cycle.size()]));
        front.insert(front.end(), sides.begin(), sides.end());
      }
    }
    if (round.faces.empty()) return;
    Eigen::Matrix3Xd points(3, Index(corners.size()));
    Index k = 0;
    for (const unsigned v : corners) points.col(k++) = point(v);
    set_extent(points, round.cylinder);
    rounds.push_back(std::move(round));
  }

  /// A coordinate axis within the accuracy of the rim is that axis.
  static void snap_axis(part::Bore& cylinder) {
    for (int d = 0; d < 3; ++d) {
      const double along = cylinder.axis_L[d];
      if (std::abs(along) > 1.0 - 1e-9) {
        cylinder.axis_L = Vector3d::Unit(d) * (along > 0.0 ? 1.0 : -1.0);
      }
    }
  }

  /// Whether the material is on the outside of the cylinder.
  bool is_hollow(std::size_t face, const part::Bore& cylinder) const {
    const auto from_axis = [&](const auto& vertices) {
      Vector3d middle = Vector3d::Zero();
      for (const unsigned v : vertices) middle += point(v);
      middle = middle / double(vertices.size()) - cylinder.p_LC;
      return (middle - middle.dot(cylinder.axis_L) * cylinder.axis_L).norm();
    };
    const auto& cell = mesh_.cells[std::size_t(mesh_.boundary[face].cell)];
    return from_axis(cell) > from_axis(facets_[face].cycle);
  }

  bool belongs(const Facet& facet, const part::Bore& cylinder,
               double widest) const {
    constexpr double kAlong = 0.3;  // of the normal: a lid has 1
    if (std::abs(facet.normal.dot(cylinder.axis_L)) > kAlong) return false;
    for (const unsigned a : facet.cycle) {
      if ((project(cylinder, point(a)) - point(a)).norm() >
          kOnCircle * cylinder.radius) {
        return false;
      }
      for (const unsigned b : facet.cycle) {
        if (std::abs(angle_between(cylinder, point(a), point(b))) > widest) {
          return false;
        }
      }
    }
    return true;
  }

  const PartMesh<3>& mesh_;
  std::vector<Facet> facets_;  ///< like mesh.boundary
  std::vector<bool> taken_;
  std::map<Edge, std::vector<std::size_t>> sides_;
  std::map<unsigned, std::vector<unsigned>> rim_;
};

}  // namespace

std::vector<FacetedRound> faceted_rounds(const PartMesh<3>& mesh) {
  if (mesh.degree > 1) return {};
  return Finder(mesh).find();
}

std::string text(const FacetedRound& round) {
  const Vector3d at = 1e3 * round.cylinder.p_LC;
  return fmt::format(
      "{} flat faces round ({:.4g}, {:.4g}, {:.4g}) mm lie on a cylinder of "
      "radius {:.5g} mm and are taken for it; name them round_… to say so",
      round.faces.size(), at.x(), at.y(), at.z(), 1e3 * round.cylinder.radius);
}

}  // namespace clevis::mesh
