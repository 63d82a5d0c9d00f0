#include "elasticity/zone_trace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/LU>

#include "mesh/simplex_basis.h"
#include "mesh/tensor_basis.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;

/// Points of a face's own coordinates: one for the side of a plane cell, two
/// for the face of a solid one.
template <int dim>
using FacePoint = Eigen::Matrix<double, dim - 1, 1>;
/// Corners of a convex piece of a face, in order.
template <int dim>
using Piece = std::vector<FacePoint<dim>>;

/// A local face as an affine image of its own coordinates.
template <int dim>
struct FaceFrame {
  Eigen::Matrix<double, dim, 1> origin, outward;
  Eigen::Matrix<double, dim, dim - 1> edges;

  /// From three (two) of the points of its rule, which are affine images too.
  FaceFrame(mesh::CellShape shape, int face) {
    const auto rule = face_gauss<dim>(shape, face, 2);
    outward = rule.outward;
    const auto own = own_points(shape);
    constexpr std::array<Index, 3> kApart = {0, 1, 2};
    Eigen::Matrix<double, dim - 1, dim - 1> from;
    Eigen::Matrix<double, dim, dim - 1> to;
    for (Index k = 0; k < dim - 1; ++k) {
      const Index q = kApart[static_cast<std::size_t>(k + 1)];
      from.col(k) = own.col(q) - own.col(0);
      to.col(k) = rule.points.col(q) - rule.points.col(0);
    }
    edges = to * from.inverse();
    origin = rule.points.col(0) - edges * own.col(0);
  }

  ReferencePoints<dim> at(
      const Eigen::Matrix<double, dim - 1, Eigen::Dynamic>& own) const {
    return (edges * own).colwise() + origin;
  }

 private:
  static Eigen::Matrix<double, dim - 1, Eigen::Dynamic> own_points(
      mesh::CellShape shape) {
    if constexpr (dim == 3) {
      if (shape == mesh::CellShape::kSimplex) {
        return mesh::simplex_gauss<2>(2).points;
      }
      const Eigen::VectorXd g = mesh::gauss(2).points;
      Eigen::Matrix2Xd points(2, 4);
      points << g[0], g[1], g[0], g[1], g[0], g[0], g[1], g[1];
      return points;
    } else {
      return mesh::gauss(2).points.transpose();
    }
  }
};

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

/// A cell's face in space.
template <int dim>
class FaceMap {
 public:
  FaceMap(const Discretization<dim>& discretization, const GroupFace& face)
      : discretization_(discretization),
        cell_(static_cast<std::size_t>(face.cell)),
        frame_(discretization.shape, face.face) {}

  const FaceFrame<dim>& frame() const { return frame_; }

  /// In space [m].
  Eigen::Matrix3Xd points(const Piece<dim>& piece) const {
    Eigen::Matrix<double, dim - 1, Eigen::Dynamic> own(
        dim - 1, static_cast<Index>(piece.size()));
    for (std::size_t k = 0; k < piece.size(); ++k) {
      own.col(static_cast<Index>(k)) = piece[k];
    }
    const auto table = tabulate_geometry<dim>(discretization_.shape,
                                              discretization_.mapping_degree(),
                                              frame_.at(own));
    Eigen::Matrix3Xd result =
        Eigen::Matrix3Xd::Constant(3, own.cols(), discretization_.mid_plane_z);
    result.topRows<dim>() =
        discretization_.cell_points[cell_] * table.values.transpose();
    return result;
  }

  /// Heights above a half-space's plane [m].
  Eigen::RowVectorXd heights(const Piece<dim>& piece,
                             const HalfSpace& space) const {
    return (space.normal.transpose() * points(piece)).array() - space.offset;
  }

 private:
  const Discretization<dim>& discretization_;
  std::size_t cell_;
  FaceFrame<dim> frame_;
};

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
    const double at = map.heights({middle}, space)[0];
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
  const Eigen::RowVectorXd height = map.heights(piece, space);
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

/// Quadrature of pieces, in the face's own coordinates.
template <int dim>
struct OwnRule {
  std::vector<FacePoint<dim>> points;
  std::vector<double> weights;

  void add(const Piece<dim>& piece, int n) {
    if constexpr (dim == 2) {
      const auto rule = mesh::gauss(n);
      const double length = piece[1][0] - piece[0][0];
      for (Index q = 0; q < rule.points.size(); ++q) {
        points.push_back(piece[0] + rule.points[q] * (piece[1] - piece[0]));
        weights.push_back(rule.weights[q] * std::abs(length));
      }
    } else {
      const auto rule = mesh::simplex_gauss<2>(n);
      for (std::size_t k = 1; k + 1 < piece.size(); ++k) {
        Eigen::Matrix2d edges;
        edges << piece[k] - piece[0], piece[k + 1] - piece[0];
        const double area = std::abs(edges.determinant());
        for (Index q = 0; q < rule.weights.size(); ++q) {
          points.push_back(piece[0] + edges * rule.points.col(q));
          weights.push_back(rule.weights[q] * area);
        }
      }
    }
  }
};

/// The rule of what of a face lies within, with the table of its basis.
template <int dim>
std::optional<FaceTable<dim>> cut_table(
    const Discretization<dim>& discretization, const GroupFace& face,
    const std::vector<HalfSpace>& bounds,
    const std::vector<std::size_t>& functions) {
  constexpr int kHalvings = 1;  // edges that bend are cut by straight pieces
  const int n =
      std::max(discretization.degree, discretization.thickness_degree) + 3;
  const FaceMap<dim> map(discretization, face);
  OwnRule<dim> own;
  for (Piece<dim> piece :
       pieces_of_face<dim>(discretization.shape, kHalvings)) {
    for (const HalfSpace& space : bounds) piece = clip(map, piece, space);
    if (!piece.empty()) own.add(piece, n);
  }
  if (own.points.empty()) return std::nullopt;
  Eigen::Matrix<double, dim - 1, Eigen::Dynamic> points(
      dim - 1, static_cast<Index>(own.points.size()));
  FaceTable<dim> table;
  table.rule.weights.resize(points.cols());
  for (Index q = 0; q < points.cols(); ++q) {
    points.col(q) = own.points[static_cast<std::size_t>(q)];
    table.rule.weights[q] = own.weights[static_cast<std::size_t>(q)];
  }
  table.rule.points = map.frame().at(points);
  table.rule.outward = map.frame().outward;
  tabulate(discretization, functions, table);
  return table;
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
                          const std::vector<int>& groups)
    : discretization(&of) {
  constexpr int kHalvings = 2;
  for (const int group : groups) {
    for (const GroupFace& face :
         of.group_faces[static_cast<std::size_t>(group)]) {
      Piece<dim> look;
      for (const auto& piece : pieces_of_face<dim>(of.shape, kHalvings)) {
        look.insert(look.end(), piece.begin(), piece.end());
      }
      faces.push_back(face);
      points.push_back(FaceMap<dim>(of, face).points(look));
    }
  }
}

template <int dim>
ZoneTrace<dim>::ZoneTrace(const WallFaces<dim>& wall,
                          const std::vector<HalfSpace>& bounds,
                          FaceTables<dim>& tables) {
  TraceBuilder<dim> builder(*wall.discretization);
  for (std::size_t k = 0; k < wall.faces.size(); ++k) {
    const GroupFace& face = wall.faces[k];
    const Side side = side_of(wall.points[k], bounds);
    if (side == Side::kWithout) continue;
    const FaceTable<dim>& whole =
        whole_face_table(*wall.discretization, face.face, tables);
    if (side == Side::kWithin) {
      builder.add(face, whole);
      continue;
    }
    auto table = cut_table(*wall.discretization, face, bounds, whole.functions);
    if (!table) continue;
    cut_.push_back(std::move(*table));
    builder.add(face, cut_.back());
  }
  trace_ = builder.finish();
}

template struct WallFaces<2>;
template struct WallFaces<3>;
template class ZoneTrace<2>;
template class ZoneTrace<3>;

}  // namespace clevis::elasticity
