#include "elasticity/nodal_loads/zone_trace.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/LU>

#include "elasticity/algebra/dense_product.h"
#include "mesh/basis/simplex_basis.h"
#include "mesh/basis/simplex_quadrature.h"
#include "mesh/basis/tensor_basis.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;

/// Corners of a convex piece of a face, in order.
template <int dim>
using Piece = std::vector<FacePoint<dim>>;

/// Pieces that a face is looked at by: halved `times` times each way.
template <int dim>
std::vector<Piece<dim>> pieces_of_face(mesh::CellShape shape, int times) {
  const int n = 1 << times;
  const double h = 1.0 / n;
  std::vector<Piece<dim>> pieces;
  if constexpr (dim == 2) {
    for (int i = 0; i < n; ++i) {
      pieces.push_back({FacePoint<dim>(i * h), FacePoint<dim>((i + 1) * h)});
    }
  } else {
    const bool simplex = shape == mesh::CellShape::kSimplex;
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < (simplex ? n - j : n); ++i) {
        const double x = i * h, y = j * h;
        if (!simplex) {
          pieces.push_back({{x, y}, {x + h, y}, {x + h, y + h}, {x, y + h}});
          continue;
        }
        pieces.push_back({{x, y}, {x + h, y}, {x, y + h}});
        if (i + j + 1 < n) {
          pieces.push_back({{x + h, y}, {x + h, y + h}, {x, y + h}});
        }
      }
    }
  }
  return pieces;
}

template <int dim>
FacePoints<dim> corners(const Piece<dim>& piece) {
  FacePoints<dim> own(dim - 1, static_cast<Index>(piece.size()));
  for (std::size_t k = 0; k < piece.size(); ++k) {
    own.col(static_cast<Index>(k)) = piece[k];
  }
  return own;
}

/// Heights above a half-space's plane [m].
template <int dim>
Eigen::RowVectorXd heights(const FaceMap<dim>& map, const FacePoints<dim>& own,
                           const HalfSpace& space) {
  return (space.normal.transpose() * map.points(own)).array() - space.offset;
}

/// Where the height between two corners is zero on the true geometry, by
/// Illinois' false position.
template <int dim>
FacePoint<dim> crossing(const FaceMap<dim>& map, const HalfSpace& space,
                        FacePoint<dim> a, FacePoint<dim> b, double at_a,
                        double at_b) {
  constexpr int kSteps = 30;
  const double enough = 1e-12 * (std::abs(at_a) + std::abs(at_b));
  FacePoint<dim> middle = a;
  for (int step = 0; step < kSteps; ++step) {
    middle = a + at_a / (at_a - at_b) * (b - a);
    const double at = heights<dim>(map, middle, space)[0];
    if (std::abs(at) <= enough) break;
    if ((at > 0.0) == (at_b > 0.0)) {
      b = middle;
      at_b = at;
      at_a *= 0.5;
    } else {
      a = middle;
      at_a = at;
      at_b *= 0.5;
    }
  }
  return middle;
}

/// The part of a piece within a half-space (Sutherland and Hodgman 1974).
template <int dim>
Piece<dim> clip(const FaceMap<dim>& map, const Piece<dim>& piece,
                const HalfSpace& space) {
  if (piece.empty()) return piece;
  const Eigen::RowVectorXd height =
      heights<dim>(map, corners<dim>(piece), space);
  if (height.maxCoeff() <= 0.0) return piece;
  if (height.minCoeff() >= 0.0) return {};
  Piece<dim> kept;
  const std::size_t n = piece.size();
  const std::size_t sides = dim == 2 ? 1 : n;  // a segment has one
  for (std::size_t k = 0; k < n; ++k) {
    const double at = height[static_cast<Index>(k)];
    if (at <= 0.0) kept.push_back(piece[k]);
    if (k >= sides) continue;
    const std::size_t next = (k + 1) % n;
    const double then = height[static_cast<Index>(next)];
    if ((at < 0.0 && then > 0.0) || (at > 0.0 && then < 0.0)) {
      kept.push_back(crossing(map, space, piece[k], piece[next], at, then));
    }
  }
  return kept.size() < static_cast<std::size_t>(dim) ? Piece<dim>{} : kept;
}

enum class Side { kWithin, kWithout, kCut };

/// How a face lies to the bounds, by points of it.
Side side_of(const Eigen::Matrix3Xd& points,
             const std::vector<HalfSpace>& bounds) {
  Side side = Side::kWithin;
  for (const HalfSpace& space : bounds) {
    const Eigen::RowVectorXd height = space.normal.transpose() * points;
    const double low = height.minCoeff() - space.offset;
    const double high = height.maxCoeff() - space.offset;
    const double round_off = 1e-9 * (high - low);
    if (low >= -round_off && high > round_off) return Side::kWithout;
    if (high > round_off) side = Side::kCut;
  }
  return side;
}

/// Rule of n points each way on [0, 1] or on the triangle.
template <int dim>
Quadrature<dim - 1> piece_rule(int n) {
  if constexpr (dim == 2) {
    auto rule = mesh::gauss(n);
    return {rule.points.transpose(), std::move(rule.weights)};
  } else {
    auto rule = mesh::simplex_gauss<2>(n);
    return {std::move(rule.points), std::move(rule.weights)};
  }
}

/// Quadrature of pieces, in the face's own coordinates.
template <int dim>
struct OwnRule {
  std::vector<FacePoint<dim>> points;
  std::vector<double> weights;

  void add(const Piece<dim>& piece, const Quadrature<dim - 1>& rule) {
    for (std::size_t k = 1; k + 1 < piece.size() + (dim == 2 ? 1 : 0); ++k) {
      Eigen::Matrix<double, dim - 1, dim - 1> edges;
      for (std::size_t d = 0; d < dim - 1; ++d) {
        edges.col(static_cast<Index>(d)) = piece[k + d] - piece[0];
      }
      const double measure = std::abs(edges.determinant());
      for (Index q = 0; q < rule.weights.size(); ++q) {
        points.push_back(piece[0] + edges * rule.points.col(q));
        weights.push_back(rule.weights[q] * measure);
      }
    }
  }
};

/// The rule of what of a face lies within.
template <int dim>
OwnRule<dim> cut_rule(mesh::CellShape shape, const FaceMap<dim>& map,
                      const std::vector<HalfSpace>& bounds,
                      const Quadrature<dim - 1>& rule) {
  constexpr int kHalvings = 1;  // edges that bend are cut by straight pieces
  OwnRule<dim> own;
  for (Piece<dim> piece : pieces_of_face<dim>(shape, kHalvings)) {
    for (const HalfSpace& space : bounds) piece = clip(map, piece, space);
    if (!piece.empty()) own.add(piece, rule);
  }
  return own;
}

/// Of a rule that has points. @param values  of the basis, points × functions.
template <int dim>
WeightedSurface cut_surface(const FaceMap<dim>& map, const OwnRule<dim>& own,
                            MatrixXd& values) {
  const auto table = map.basis().at(corners<dim>(own.points));
  values = product(table.value, map.basis().displacement());
  auto surface = map.surface(table);
  for (Index q = 0; q < surface.areas.cols(); ++q) {
    surface.areas.col(q) *= own.weights[static_cast<std::size_t>(q)];
  }
  return {std::move(surface.points), std::move(surface.areas)};
}

void add_bounds(const Vector3d& direction, const Vector3d& from, double low,
                double high, std::vector<HalfSpace>& bounds) {
  const double at = direction.dot(from);
  if (std::isfinite(low)) bounds.push_back({-direction, -(at + low)});
  if (std::isfinite(high)) bounds.push_back({direction, at + high});
}

}  // namespace

std::vector<HalfSpace> bounds_of(const loads::Seat& seat,
                                 const loads::ContactZone& zone) {
  std::vector<HalfSpace> bounds;
  add_bounds(seat.slide->along_L, seat.p_LS, zone.low[0], zone.high[0], bounds);
  add_bounds(seat.slide->across_L, seat.p_LS, zone.low[1], zone.high[1],
             bounds);
  return bounds;
}

template <int dim>
WallFaces<dim>::WallFaces(const Discretization<dim>& of,
                          const std::vector<int>& groups,
                          FaceTables<dim>& tables)
    : discretization(&of),
      cut_rule(piece_rule<dim>(std::max(of.degree, of.thickness_degree) + 3)) {
  constexpr int kHalvings = 2;
  Piece<dim> look;
  for (const auto& piece : pieces_of_face<dim>(of.shape, kHalvings)) {
    look.insert(look.end(), piece.begin(), piece.end());
  }
  const FacePoints<dim> points = corners<dim>(look);
  for (const int group : groups) {
    for (const GroupFace& face :
         of.group_faces[static_cast<std::size_t>(group)]) {
      const auto& basis =
          bases.try_emplace(face.face, of, face.face).first->second;
      const FaceMap<dim> map(of, basis, face.cell);
      const auto& table = whole_face_table(of, face.face, tables);
      faces.push_back({face.cell, map, map.points(points), &table,
                       weighted_surface(of, face.cell, table)});
    }
  }
}

template <int dim>
ZoneTrace<dim>::ZoneTrace(const WallFaces<dim>& wall,
                          const std::vector<HalfSpace>& bounds) {
  TraceBuilder<dim> builder(*wall.discretization);
  for (const auto& face : wall.faces) {
    const Side side = side_of(face.points, bounds);
    if (side == Side::kWithout) continue;
    if (side == Side::kWithin) {
      builder.add(face.cell, face.whole->functions, face.whole->values,
                  face.surface);
      continue;
    }
    const auto rule = cut_rule<dim>(wall.discretization->shape, face.map,
                                    bounds, wall.cut_rule);
    if (rule.points.empty()) continue;
    MatrixXd& values = cut_.emplace_back();
    const auto surface = cut_surface<dim>(face.map, rule, values);
    builder.add(face.cell, face.map.basis().functions(), values, surface);
  }
  trace_ = builder.finish();
}

template struct WallFaces<2>;
template struct WallFaces<3>;
template class ZoneTrace<2>;
template class ZoneTrace<3>;

}  // namespace clevis::elasticity
