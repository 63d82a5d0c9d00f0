#include "mesh/cells/section.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include <Eigen/Dense>

#include "mesh/basis/simplex_basis.h"
#include "mesh/basis/tensor_basis.h"
#include "mesh/cells/topology.h"

namespace clevis::mesh {

namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;

/// The six tetrahedra of a cube around its diagonal, by corner bits.
constexpr std::array<std::array<int, 4>, 6> kTetrahedra = {{{0, 1, 3, 7},
                                                            {0, 1, 5, 7},
                                                            {0, 2, 3, 7},
                                                            {0, 2, 6, 7},
                                                            {0, 4, 5, 7},
                                                            {0, 4, 6, 7}}};

struct Plane {
  Vector3d point, normal;
  /// Of nodes on the plane cells have round-off of their own: it is none.
  double height(const Vector3d& p) const {
    constexpr double kRoundOff = 1e-11;
    const double above = (p - point).dot(normal);
    return std::abs(above) <= kRoundOff * (p.norm() + point.norm()) ? 0.0
                                                                    : above;
  }
};

/// Where an edge meets the plane. A point on the plane counts as above, so
/// that a plane through nodes is cut exactly once.
struct Cut {
  static bool above(double height) { return height >= 0.0; }
  static Vector3d at(const Vector3d& p, double hp, const Vector3d& q,
                     double hq) {
    return p + hp / (hp - hq) * (q - p);
  }
};

/// Even points of a cell that is cut.
struct CutCell {
  Matrix3Xd points;
  Eigen::VectorXd heights;  ///< above the plane [m]

  bool is_cut() const { return points.cols() > 0; }
  Vector3d meet(Index a, Index b) const {
    return Cut::at(points.col(a), heights[a], points.col(b), heights[b]);
  }
};

/// Collects the polygons of a section.
class Sum {
 public:
  explicit Sum(const Plane& plane) : plane_(plane) {}

  void add_tetrahedron(const CutCell& cell,
                       const std::array<Index, 4>& corners) {
    std::array<Index, 4> up{}, down{};
    std::size_t ups = 0, downs = 0;
    for (const Index corner : corners) {
      if (Cut::above(cell.heights[corner])) {
        up[ups++] = corner;
      } else {
        down[downs++] = corner;
      }
    }
    const auto meet = [&](Index a, Index b) {
      return cell.meet(a, b);
    };
    if (ups == 1) {
      add(meet(up[0], down[0]), meet(up[0], down[1]), meet(up[0], down[2]));
    } else if (ups == 3) {
      add(meet(up[0], down[0]), meet(up[1], down[0]), meet(up[2], down[0]));
    } else if (ups == 2) {
      const Vector3d a = meet(up[0], down[0]), b = meet(up[1], down[0]);
      const Vector3d c = meet(up[1], down[1]), d = meet(up[0], down[1]);
      add(a, b, c);
      add(a, c, d);
    }
  }

  void finish(Section& section) const {
    section.area = area_;
    if (!(area_ > 0.0)) return;
    const Vector3d mean = first_ / area_;
    section.centroid = plane_.point + mean;
    section.second_moment = second_ - area_ * mean * mean.transpose();
  }

 private:
  /// A triangle; its moments are exact at the middles of its edges.
  void add(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    const double area = 0.5 * (b - a).cross(c - a).norm();
    area_ += area;
    for (const Vector3d& p :
         {Vector3d(a + b), Vector3d(b + c), Vector3d(c + a)}) {
      const Vector3d r = 0.5 * p - plane_.point;
      first_ += area / 3.0 * r;
      second_ += area / 3.0 * r * r.transpose();
    }
  }

  const Plane& plane_;
  double area_ = 0.0;
  Vector3d first_ = Vector3d::Zero();
  Matrix3d second_ = Matrix3d::Zero();
};

Eigen::VectorXd heights_of(const Matrix3Xd& points, const Plane& plane) {
  Eigen::VectorXd heights(points.cols());
  for (Index i = 0; i < points.cols(); ++i) {
    heights[i] = plane.height(points.col(i));
  }
  return heights;
}

bool crosses(const Matrix3Xd& points, const Plane& plane) {
  bool above = false, below = false;
  for (Index i = 0; i < points.cols() && !(above && below); ++i) {
    (Cut::above(plane.height(points.col(i))) ? above : below) = true;
  }
  return above && below;
}

/// Spares a look at each point of the cells that a plane is far from.
struct Ball {
  Vector3d centre;
  double radius{};

  bool is_clear_of(const Plane& plane) const {
    constexpr double kRoundOff = 1e-9;
    const Vector3d way = centre - plane.point;
    return std::abs(way.dot(plane.normal)) >
           radius + kRoundOff * (way.norm() + centre.norm());
  }
};

std::vector<Ball> balls_of(const PartMesh<3>& mesh) {
  std::vector<Ball> balls;
  balls.reserve(mesh.cells.size());
  for (const Matrix3Xd& points : mesh.cell_points) {
    const Vector3d centre = points.rowwise().mean();
    balls.push_back(
        {centre,
         std::sqrt(
             (points.colwise() - centre).colwise().squaredNorm().maxCoeff())});
  }
  return balls;
}

/// Even points of a cell, and the pieces between them.
struct Subdivision {
  MatrixXd to_even;  ///< one direction of a hexahedron, or all of the simplex
  bool tensor = true;
  std::vector<std::array<Index, 4>> tetrahedra;
  std::vector<std::vector<Index>> faces;  ///< even points on each
  std::vector<std::pair<std::size_t, std::size_t>> lines;  ///< of a face

  Matrix3Xd points_of(const Matrix3Xd& cell_points) const {
    if (!tensor) return cell_points * to_even.transpose();
    return interpolate<3>(cell_points, {&to_even, &to_even, &to_even});
  }
};

Index grid_index(int parts, const std::array<int, 3>& i) {
  return i[0] + (parts + 1) * (i[1] + Index(parts + 1) * i[2]);
}

Subdivision subdivide_hexahedron(int degree, int parts) {
  const int row = parts + 1;
  Subdivision result;
  result.to_even =
      lagrange(gauss_lobatto(degree), Eigen::VectorXd::LinSpaced(row, 0.0, 1.0))
          .value;
  for (int cube = 0; cube < parts * parts * parts; ++cube) {
    for (const auto& tetrahedron : kTetrahedra) {
      auto& corners = result.tetrahedra.emplace_back();
      for (std::size_t v = 0; v < 4; ++v) {
        const int bits = tetrahedron[v];
        corners[v] =
            grid_index(parts, {cube % parts + (bits & 1),
                               cube / parts % parts + (bits >> 1 & 1),
                               cube / (parts * parts) + (bits >> 2 & 1)});
      }
    }
  }
  for (std::size_t face = 0; face < 6; ++face) {
    auto& on = result.faces.emplace_back();
    for (int q = 0; q < row * row; ++q) {
      std::array<int, 3> i{};
      i[face / 2] = int(face % 2) * parts;
      i[(face / 2 + 1) % 3] = q % row;
      i[(face / 2 + 2) % 3] = q / row;
      on.push_back(grid_index(parts, i));
    }
  }
  const auto ends = std::size_t(row);
  for (std::size_t j = 0; j < ends; ++j) {
    for (std::size_t i = 0; i + 1 < ends; ++i) {
      result.lines.emplace_back(i + ends * j, i + 1 + ends * j);
      result.lines.emplace_back(j + ends * i, j + ends * (i + 1));
    }
  }
  return result;
}

Subdivision subdivide_tetrahedron(int degree, int finest) {
  const int parts = degree == 1 ? 1 : finest;
  Subdivision result;
  const auto lattice = simplex_lattice<3>(parts);
  SimplexPoints<3> even(3, Index(lattice.size()));
  for (std::size_t i = 0; i < lattice.size(); ++i) {
    for (std::size_t d = 0; d < 3; ++d) {
      even(Index(d), Index(i)) = double(lattice[i][d + 1]) / parts;
    }
  }
  result.to_even = simplex_lagrange<3>(degree, even).value;
  result.tensor = false;
  for (const auto& [a, b, c, d] : simplex_parts<3>(parts)) {
    result.tetrahedra.push_back({a, b, c, d});
  }
  for (int face = 0; face < 4; ++face) {
    const auto on = simplex_face_lattice<3>(parts, face);
    result.faces.emplace_back(on.begin(), on.end());
  }
  for (const auto& part : simplex_parts<2>(parts)) {
    for (std::size_t v = 0; v < 3; ++v) {
      const auto ends = std::minmax(part[v], part[(v + 1) % 3]);
      const std::pair line(std::size_t(ends.first), std::size_t(ends.second));
      if (std::find(result.lines.begin(), result.lines.end(), line) ==
          result.lines.end()) {
        result.lines.push_back(line);
      }
    }
  }
  return result;
}

/// Points where the lines of a boundary face meet the plane.
void add_rim(const CutCell& cell, const std::vector<Index>& face,
             const Subdivision& subdivision, std::vector<Vector3d>& rim) {
  for (const auto& [from, to] : subdivision.lines) {
    const Index a = face[from], b = face[to];
    if (Cut::above(cell.heights[a]) != Cut::above(cell.heights[b])) {
      rim.push_back(cell.meet(a, b));
    }
  }
}

using Neighbours = std::vector<std::array<std::pair<int, int>, 6>>;

int count_pieces(const Neighbours& other, const std::vector<CutCell>& cut,
                 const Subdivision& subdivision) {
  const auto face_is_cut = [&](std::size_t cell, std::size_t face) {
    const auto is_above = [&](Index point) {
      return Cut::above(cut[cell].heights[point]);
    };
    const auto& points = subdivision.faces[face];
    return std::ranges::any_of(points, is_above) &&
           !std::ranges::all_of(points, is_above);
  };
  std::vector<bool> seen(cut.size(), false);
  int pieces = 0;
  for (std::size_t seed = 0; seed < cut.size(); ++seed) {
    if (seen[seed] || !cut[seed].is_cut()) continue;
    ++pieces;
    std::vector<std::size_t> front = {seed};
    seen[seed] = true;
    while (!front.empty()) {
      const std::size_t cell = front.back();
      front.pop_back();
      for (std::size_t face = 0; face < subdivision.faces.size(); ++face) {
        const int next = other[cell][face].first;
        if (next < 0 || seen[std::size_t(next)] ||
            !cut[std::size_t(next)].is_cut() || !face_is_cut(cell, face)) {
          continue;
        }
        seen[std::size_t(next)] = true;
        front.push_back(std::size_t(next));
      }
    }
  }
  return pieces;
}

}  // namespace

struct SectionCutter::Cells {
  Subdivision subdivision;
  Neighbours neighbours;
  std::vector<Ball> balls;  ///< that hold the points of each cell
};

SectionCutter::SectionCutter(const PartMesh<3>& mesh, int parts)
    : mesh_(&mesh),
      cells_(std::make_shared<const Cells>(
          mesh.shape == CellShape::kTensor
              ? subdivide_hexahedron(mesh.degree, parts)
              : subdivide_tetrahedron(mesh.degree, parts),
          neighbours(mesh), balls_of(mesh))) {}

Section SectionCutter::at(const Vector3d& point, const Vector3d& normal) const {
  const PartMesh<3>& mesh = *mesh_;
  const Subdivision& subdivision = cells_->subdivision;
  const Plane plane{point, normal.normalized()};
  Section section;
  Sum sum(plane);
  std::vector<CutCell> cut_cells(mesh.cells.size());
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    if (cells_->balls[c].is_clear_of(plane)) continue;
    // The points of a curved cell reach beyond its corners: take all.
    if (!crosses(mesh.cell_points[c], plane)) continue;
    CutCell& cell = cut_cells[c];
    cell.points = subdivision.points_of(mesh.cell_points[c]);
    cell.heights = heights_of(cell.points, plane);
    for (const auto& corners : subdivision.tetrahedra) {
      sum.add_tetrahedron(cell, corners);
    }
  }
  sum.finish(section);
  for (const BoundaryFace& face : mesh.boundary) {
    const CutCell& cell = cut_cells[std::size_t(face.cell)];
    if (!cell.is_cut()) continue;
    add_rim(cell, subdivision.faces[std::size_t(face.face)], subdivision,
            section.rim);
  }
  section.pieces = count_pieces(cells_->neighbours, cut_cells, subdivision);
  return section;
}

Section cut(const PartMesh<3>& mesh, const Vector3d& point,
            const Vector3d& normal, int parts) {
  return SectionCutter(mesh, parts).at(point, normal);
}

}  // namespace clevis::mesh
