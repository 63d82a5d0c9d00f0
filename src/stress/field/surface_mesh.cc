#include "stress/field/surface_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "elasticity/fe_space/tabulation.h"
#include "mesh/basis/simplex_basis.h"

namespace clevis::stress {
namespace {

using Eigen::Index;

/// Lattice points of a piece of a cell's boundary, outward: a quadrangle or
/// triangle, of a flat cell an edge.
using Facet = std::vector<int>;

/// How the lattice of a cell makes surface.
struct CellPattern {
  std::vector<Facet> facets;  ///< of the cell's boundary
  std::vector<Facet> sheet;   ///< of a flat cell: its own area
};

/// Quadrangles of the cell [0, n]^3 on the face where axis d has its lower or
/// upper end.
void add_square_face(int n, int d, bool upper, std::vector<Facet>& facets) {
  const std::array<int, 3> stride{1, n + 1, (n + 1) * (n + 1)};
  const int u = stride[static_cast<std::size_t>((d + 1) % 3)];
  const int v = stride[static_cast<std::size_t>((d + 2) % 3)];
  const int base = upper ? n * stride[static_cast<std::size_t>(d)] : 0;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const int at = base + i * u + j * v;
      if (upper) {
        facets.push_back({at, at + u, at + u + v, at + v});
      } else {
        facets.push_back({at, at + v, at + u + v, at + u});
      }
    }
  }
}

template <int dim>
CellPattern tensor_pattern(int n) {
  CellPattern pattern;
  if constexpr (dim == 3) {
    for (int d = 0; d < 3; ++d) {
      add_square_face(n, d, false, pattern.facets);
      add_square_face(n, d, true, pattern.facets);
    }
  } else {
    const int row = n + 1;
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const int at = i + j * row;
        pattern.sheet.push_back({at, at + 1, at + 1 + row, at + row});
      }
    }
    for (int i = 0; i < n; ++i) {
      pattern.facets.push_back({i, i + 1});
      pattern.facets.push_back({i + 1 + n * row, i + n * row});
      pattern.facets.push_back({n + i * row, n + (i + 1) * row});
      pattern.facets.push_back({(i + 1) * row, i * row});
    }
  }
  return pattern;
}

/// Facets of a part of a simplex's lattice, outward.
std::vector<Facet> facets_of(const std::array<int, 4>& p) {
  return {{p[0], p[2], p[1]},
          {p[0], p[1], p[3]},
          {p[0], p[3], p[2]},
          {p[1], p[2], p[3]}};
}
std::vector<Facet> facets_of(const std::array<int, 3>& p) {
  return {{p[0], p[1]}, {p[1], p[2]}, {p[2], p[0]}};
}

template <int dim>
CellPattern simplex_pattern(int n) {
  CellPattern pattern;
  std::map<std::vector<int>, std::vector<Facet>> by_points;
  for (const auto& part : mesh::simplex_parts<dim>(n)) {
    if constexpr (dim == 2) {
      pattern.sheet.emplace_back(part.begin(), part.end());
    }
    for (const Facet& facet : facets_of(part)) {
      std::vector<int> key = facet;
      std::ranges::sort(key);
      by_points[key].push_back(facet);
    }
  }
  for (const auto& [key, facets] : by_points) {
    if (facets.size() == 1) pattern.facets.push_back(facets.front());
  }
  return pattern;
}

/// Numbers of positions: the same for points that coincide.
class PointNumbers {
 public:
  /// @param low, high  ends of what holds all points [m].
  PointNumbers(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
    constexpr double kSame = 1e-7;
    step_ = kSame * (high - low).maxCoeff();
    // Round numbers of millimetres must not stand where rounding turns.
    origin_ = low - step_ * Eigen::Vector3d(0.2931, 0.3137, 0.2771);
  }

  int operator()(const Eigen::Vector3d& position) {
    const Eigen::Array3d cell = ((position - origin_) / step_).array().round();
    const std::array<std::int64_t, 3> key{static_cast<std::int64_t>(cell[0]),
                                          static_cast<std::int64_t>(cell[1]),
                                          static_cast<std::int64_t>(cell[2])};
    return numbers_.try_emplace(key, static_cast<int>(numbers_.size()))
        .first->second;
  }

 private:
  double step_{};
  Eigen::Vector3d origin_;
  std::map<std::array<std::int64_t, 3>, int> numbers_;
};

/// Ends of what holds all points of a field [m].
struct Extent {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(1e300);
  Eigen::Vector3d high = Eigen::Vector3d::Constant(-1e300);
};
Extent extent_of(const InstantField& field) {
  Extent extent;
  for (const auto& cell : field.points) {
    extent.low = extent.low.cwiseMin(cell.colwise().minCoeff().transpose());
    extent.high = extent.high.cwiseMax(cell.colwise().maxCoeff().transpose());
  }
  return extent;
}

/// The cells along Morton's curve through their middles, so that neighbours
/// stand near one another in the list: differences from one to the next are
/// small, and take few bytes in a picture.
std::vector<int> along_a_curve(const InstantField& field) {
  constexpr int kBits = 16;
  const auto [low, high] = extent_of(field);
  const double step = (high - low).maxCoeff() / ((1 << kBits) - 1);
  std::vector<std::pair<std::uint64_t, int>> places;
  for (std::size_t c = 0; c < field.points.size(); ++c) {
    const Eigen::Vector3d middle = field.points[c].colwise().mean();
    std::uint64_t along = 0;
    for (int bit = kBits - 1; bit >= 0; --bit) {
      for (int d = 0; d < 3; ++d) {
        const auto at = static_cast<std::uint64_t>((middle[d] - low[d]) / step);
        along = along << 1 | (at >> bit & 1U);
      }
    }
    places.emplace_back(along, static_cast<int>(c));
  }
  std::ranges::sort(places);
  std::vector<int> cells;
  for (const auto& [along, cell] : places) cells.push_back(cell);
  return cells;
}

/// A facet of a cell.
struct CellFacet {
  int cell{};
  const Facet* facet{};
};

/// Those of one cell alone.
/// @param cells  in the order in which their facets come.
std::vector<CellFacet> outer_facets(const CellPattern& pattern,
                                    const InstantField& field,
                                    const std::vector<int>& cells) {
  constexpr std::size_t kMostPoints = 4;
  using Points = std::array<int, kMostPoints>;
  const auto [low, high] = extent_of(field);
  PointNumbers number_of(low, high);
  std::vector<CellFacet> facets;
  std::vector<std::pair<Points, std::size_t>> places;  // by their points
  for (const int c : cells) {
    const auto& points = field.points[static_cast<std::size_t>(c)];
    for (const Facet& facet : pattern.facets) {
      Points key;
      key.fill(-1);
      std::ranges::transform(facet, key.begin(), [&](int q) {
        return number_of(points.row(q).transpose());
      });
      std::ranges::sort(key);
      places.emplace_back(key, facets.size());
      facets.push_back({c, &facet});
    }
  }
  std::ranges::sort(places);
  std::vector<bool> is_shared(facets.size(), false);
  for (std::size_t i = 1; i < places.size(); ++i) {
    if (places[i].first != places[i - 1].first) continue;
    is_shared[places[i].second] = is_shared[places[i - 1].second] = true;
  }
  std::vector<CellFacet> outer;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    if (!is_shared[f]) outer.push_back(facets[f]);
  }
  return outer;
}

/// Collects points in the order in which they are asked for.
class PointList {
 public:
  explicit PointList(std::vector<FieldPoint>& points) : points_(points) {}
  int operator()(int cell, int point) {
    const auto [found, is_new] =
        places_.try_emplace({cell, point}, static_cast<int>(points_.size()));
    if (is_new) points_.push_back({cell, point});
    return found->second;
  }

 private:
  std::vector<FieldPoint>& points_;
  std::map<std::array<int, 2>, int> places_;
};

/// Triangles of a facet, a fan from its first point.
void add_triangles(int cell, const Facet& facet, PointList& place,
                   SurfaceMesh& surface) {
  for (std::size_t k = 1; k + 1 < facet.size(); ++k) {
    surface.triangles.push_back({place(cell, facet[0]), place(cell, facet[k]),
                                 place(cell, facet[k + 1])});
  }
}

/// Which sides of the cell a reference point lies on.
template <int dim>
std::vector<bool> sides_of(mesh::CellShape shape,
                           const Eigen::Matrix<double, dim, 1>& point) {
  constexpr double kOn = 1e-9;
  std::vector<bool> sides;
  for (int d = 0; d < dim; ++d) {
    sides.push_back(point[d] < kOn);
    if (shape == mesh::CellShape::kTensor) sides.push_back(point[d] > 1 - kOn);
  }
  if (shape == mesh::CellShape::kSimplex) {
    sides.push_back(point.sum() > 1 - kOn);
  }
  return sides;
}

}  // namespace

template <int dim>
SurfaceMesh surface_mesh(mesh::CellShape shape, const InstantField& field) {
  const CellPattern pattern = shape == mesh::CellShape::kTensor
                                  ? tensor_pattern<dim>(field.subdivisions)
                                  : simplex_pattern<dim>(field.subdivisions);
  SurfaceMesh surface;
  PointList place(surface.points);
  const std::vector<int> cells = along_a_curve(field);
  for (const int c : cells) {
    for (const Facet& facet : pattern.sheet) {
      add_triangles(c, facet, place, surface);
    }
  }
  for (const CellFacet& outer : outer_facets(pattern, field, cells)) {
    if constexpr (dim == 3) {
      add_triangles(outer.cell, *outer.facet, place, surface);
    } else {
      surface.outline.push_back({place(outer.cell, (*outer.facet)[0]),
                                 place(outer.cell, (*outer.facet)[1])});
    }
  }
  return surface;
}

SharedPoints share_points(const Eigen::MatrixX3d& positions,
                          const Eigen::MatrixXd& values, double tolerance) {
  SharedPoints shared;
  if (positions.rows() == 0) return shared;
  PointNumbers place_of(positions.colwise().minCoeff().transpose(),
                        positions.colwise().maxCoeff().transpose());
  const Eigen::MatrixXd columns = values.transpose();  // of a point together
  std::vector<std::vector<int>> kept_at;               // per place
  for (Index p = 0; p < positions.rows(); ++p) {
    const auto place =
        static_cast<std::size_t>(place_of(positions.row(p).transpose()));
    if (place == kept_at.size()) kept_at.emplace_back();
    const auto same = std::ranges::find_if(kept_at[place], [&](int number) {
      const Index other = shared.kept[static_cast<std::size_t>(number)];
      return (columns.col(p) - columns.col(other)).lpNorm<Eigen::Infinity>() <=
             tolerance;
    });
    if (same == kept_at[place].end()) {
      kept_at[place].push_back(static_cast<int>(shared.kept.size()));
      shared.number.push_back(kept_at[place].back());
      shared.kept.push_back(static_cast<int>(p));
    } else {
      shared.number.push_back(*same);
    }
  }
  return shared;
}

template <int dim>
int stand_in(mesh::CellShape shape, int fine, int fine_point, int coarse) {
  const auto points = elasticity::lattice<dim>(shape, coarse);
  const Eigen::Matrix<double, dim, 1> wanted =
      elasticity::lattice<dim>(shape, fine).col(fine_point);
  const auto sides = sides_of<dim>(shape, wanted);
  constexpr double kFar = 2.0;  // beyond any distance in a cell
  Index nearest = 0;
  double least = HUGE_VAL;
  for (Index q = 0; q < points.cols(); ++q) {
    const auto there = sides_of<dim>(shape, points.col(q));
    if (!std::ranges::equal(sides, there, std::ranges::less_equal())) continue;
    const double distance =
        (points.col(q) - wanted).norm() +
        kFar * static_cast<double>(std::ranges::count(there, true));
    if (distance < least) {
      least = distance;
      nearest = q;
    }
  }
  return static_cast<int>(nearest);
}

template SurfaceMesh surface_mesh<2>(mesh::CellShape, const InstantField&);
template SurfaceMesh surface_mesh<3>(mesh::CellShape, const InstantField&);
template int stand_in<2>(mesh::CellShape, int, int, int);
template int stand_in<3>(mesh::CellShape, int, int, int);

}  // namespace clevis::stress
