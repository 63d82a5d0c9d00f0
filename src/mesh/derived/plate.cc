#include "mesh/derived/plate.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "mesh/basis/tensor_basis.h"
#include "mesh/cells/topology.h"
#include "mesh/derived/tetrahedra_plate.h"

namespace clevis::mesh {

namespace {

using Eigen::Index;

/// Which cell axis runs along z, and its sense.
struct Upright {
  int axis = -1;
  bool up = true;
};

/// Index of the point (a, b, c) of a cell whose axes first, second, upright
/// these count along.
struct PlateAxes {
  PlateAxes(const Upright& upright, int degree)
      : u((upright.axis + 1) % 3),
        v((upright.axis + 2) % 3),
        w(upright.axis),
        n(degree + 1),
        up(upright.up) {
    // Upside down the other two change places: right-handed from above.
    if (!up) std::swap(u, v);
  }
  Index index(int a, int b, int c) const {
    std::array<int, 3> i{};
    i[std::size_t(u)] = a;
    i[std::size_t(v)] = b;
    i[std::size_t(w)] = up ? c : n - 1 - c;
    return i[0] + n * (i[1] + Index(n) * i[2]);
  }
  int u, v, w, n;
  bool up;
};

/// The axis along which all grid lines are straight, parallel to z, and at
/// one height each; axis -1 if there is none.
Upright find_upright(const Eigen::Matrix3Xd& points, int degree,
                     const Eigen::VectorXd& nodes, double tolerance) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool up : {true, false}) {
      const PlateAxes axes({axis, up}, degree);
      const double low = points(2, axes.index(0, 0, 0));
      const double high = points(2, axes.index(0, 0, degree));
      bool fits = high - low > tolerance;
      for (int b = 0; b <= degree && fits; ++b) {
        for (int a = 0; a <= degree && fits; ++a) {
          const Eigen::Vector3d foot = points.col(axes.index(a, b, 0));
          for (int c = 0; c <= degree && fits; ++c) {
            Eigen::Vector3d want = foot;
            want.z() = low + nodes[c] * (high - low);
            fits = (points.col(axes.index(a, b, c)) - want)
                       .cwiseAbs()
                       .maxCoeff() <= tolerance;
          }
        }
      }
      if (fits) return {axis, up};
    }
  }
  return {};
}

/// A cell on the bottom and those above it.
using Column = std::vector<int>;

class Plate {
 public:
  explicit Plate(const PartMesh<3>& mesh)
      : mesh_(mesh), other_(neighbours(mesh)), group_(mesh.cells.size()) {
    for (auto& cell : group_) cell.fill(-1);
    for (const auto& face : mesh.boundary) {
      group_[std::size_t(face.cell)][std::size_t(face.face)] = face.group;
    }
  }

  std::optional<PartMesh<2>> mid_plane() {
    if (!find_axes() || !find_columns()) return std::nullopt;
    if (!groups_fit()) return std::nullopt;
    return flat_mesh();
  }

 private:
  int face(int cell, bool top) const {
    const Upright& upright = upright_[std::size_t(cell)];
    return 2 * upright.axis + (upright.up == top ? 1 : 0);
  }
  PlateAxes axes(int cell) const {
    return {upright_[std::size_t(cell)], mesh_.degree};
  }

  bool find_axes() {
    // gmsh places the curved nodes of a layer to about 1e-10 of the size.
    const double tolerance = 1e-8 * size_of(mesh_);
    const Eigen::VectorXd nodes = gauss_lobatto(mesh_.degree);
    for (const auto& points : mesh_.cell_points) {
      upright_.push_back(find_upright(points, mesh_.degree, nodes, tolerance));
      if (upright_.back().axis < 0) return false;
    }
    const auto lower = [](const auto& a, const auto& b) {
      return a.z() < b.z();
    };
    const auto [low, high] = std::minmax_element(mesh_.vertices.begin(),
                                                 mesh_.vertices.end(), lower);
    low_ = low->z();
    high_ = high->z();
    tolerance_ = tolerance;
    return true;
  }

  /// Height of a cell's bottom or top.
  double height(int cell, bool top) const {
    return mesh_.cell_points[std::size_t(cell)](
        2, axes(cell).index(0, 0, top ? mesh_.degree : 0));
  }

  bool find_columns() {
    std::size_t found = 0;
    for (int cell = 0; cell < int(mesh_.cells.size()); ++cell) {
      if (other_[std::size_t(cell)][std::size_t(face(cell, false))].first >=
          0) {
        continue;
      }
      if (std::abs(height(cell, false) - low_) > tolerance_) return false;
      Column column = {cell};
      for (int next = cell; next >= 0;) {
        next = other_[std::size_t(next)][std::size_t(face(next, true))].first;
        if (next >= 0) column.push_back(next);
      }
      if (std::abs(height(column.back(), true) - high_) > tolerance_) {
        return false;
      }
      found += column.size();
      columns_.push_back(std::move(column));
    }
    return found == mesh_.cells.size();
  }

  /// Local side face of `cell` on the quad edge `edge` (2 d + side) of the
  /// column whose bottom is `bottom`.
  int side_face(int cell, int bottom, int edge) const {
    if (cell == bottom) {
      const PlateAxes a = axes(cell);
      return 2 * (edge / 2 == 0 ? a.u : a.v) + edge % 2;
    }
    // Cells of a column may be turned: find the face over the same edge.
    const auto [p, q] = edge_points(bottom, edge);
    for (int e = 0; e < 4; ++e) {
      const auto [r, s] = edge_points(cell, e);
      if (((p - r).norm() < tolerance_ && (q - s).norm() < tolerance_) ||
          ((p - s).norm() < tolerance_ && (q - r).norm() < tolerance_)) {
        return side_face(cell, cell, e);
      }
    }
    return -1;
  }

  /// Ends of a bottom edge in the plane.
  std::pair<Eigen::Vector2d, Eigen::Vector2d> edge_points(int cell,
                                                          int edge) const {
    const PlateAxes a = axes(cell);
    const auto& points = mesh_.cell_points[std::size_t(cell)];
    const int k = mesh_.degree, side = (edge % 2) * k;
    const Index from =
        edge / 2 == 0 ? a.index(side, 0, 0) : a.index(0, side, 0);
    const Index to = edge / 2 == 0 ? a.index(side, k, 0) : a.index(k, side, 0);
    return {points.col(from).head<2>(), points.col(to).head<2>()};
  }

  /// Each side edge carries one group through the thickness.
  bool groups_fit() {
    for (const Column& column : columns_) {
      std::array<int, 4> groups{};
      for (int edge = 0; edge < 4; ++edge) {
        for (std::size_t layer = 0; layer < column.size(); ++layer) {
          const int cell = column[layer];
          const int side = side_face(cell, column[0], edge);
          if (side < 0) return false;
          const bool outside =
              other_[std::size_t(cell)][std::size_t(side)].first < 0;
          const int group =
              outside ? group_[std::size_t(cell)][std::size_t(side)] : kInside;
          if (layer == 0) groups[std::size_t(edge)] = group;
          if (group != groups[std::size_t(edge)]) return false;
        }
      }
      edge_groups_.push_back(groups);
    }
    return true;
  }

  /// Groups with a face on top or bottom stay in 3-D: in the plane a load on
  /// them would get lost in part.
  std::vector<int> side_groups(PartMesh<2>& flat) const {
    std::vector<bool> on_lid(mesh_.groups.size(), false);
    for (const Column& column : columns_) {
      for (const auto& [cell, top] :
           {std::pair(column.front(), false), std::pair(column.back(), true)}) {
        const int group =
            group_[std::size_t(cell)][std::size_t(face(cell, top))];
        if (group >= 0) on_lid[std::size_t(group)] = true;
      }
    }
    std::vector<int> renumbered(mesh_.groups.size(), -1);
    for (std::size_t g = 0; g < on_lid.size(); ++g) {
      if (on_lid[g]) continue;
      renumbered[g] = int(flat.groups.size());
      flat.groups.push_back(mesh_.groups[g]);
    }
    return renumbered;
  }

  PartMesh<2> flat_mesh() const {
    PartMesh<2> flat;
    flat.degree = mesh_.degree;
    flat.thickness = high_ - low_;
    flat.mid_plane_z = 0.5 * (high_ + low_);
    const std::vector<int> group = side_groups(flat);
    std::map<unsigned, unsigned> number;  // ascending: order of the 3-D mesh
    std::vector<std::array<unsigned, 4>> corners;
    for (const Column& column : columns_) {
      corners.push_back(bottom_corners(column[0]));
      for (const unsigned v : corners.back()) number.emplace(v, 0u);
    }
    for (auto& [old, now] : number) {
      now = unsigned(flat.vertices.size());
      flat.vertices.emplace_back(mesh_.vertices[old].head<2>());
    }
    for (std::size_t q = 0; q < columns_.size(); ++q) {
      auto& cell = flat.cells.emplace_back();
      for (const unsigned v : corners[q]) cell.push_back(number.at(v));
      flat.cell_points.push_back(bottom_points(columns_[q][0]));
      for (int edge = 0; edge < 4; ++edge) {
        const int g = edge_groups_[q][std::size_t(edge)];
        if (g == kInside) continue;
        flat.boundary.push_back(
            {int(q), edge, g < 0 ? -1 : group[std::size_t(g)]});
      }
    }
    return flat;
  }

  std::array<unsigned, 4> bottom_corners(int cell) const {
    const PlateAxes a(upright_[std::size_t(cell)], 1);
    const auto& vertices = mesh_.cells[std::size_t(cell)];
    std::array<unsigned, 4> corners{};
    for (int v = 0; v < 4; ++v) {
      corners[std::size_t(v)] =
          vertices[std::size_t(a.index(v & 1, v >> 1, 0))];
    }
    return corners;
  }

  Eigen::Matrix2Xd bottom_points(int cell) const {
    const PlateAxes a = axes(cell);
    Eigen::Matrix2Xd points(2, a.n * a.n);
    for (int j = 0; j < a.n; ++j) {
      for (int i = 0; i < a.n; ++i) {
        points.col(i + a.n * j) = mesh_.cell_points[std::size_t(cell)]
                                      .col(a.index(i, j, 0))
                                      .head<2>();
      }
    }
    return points;
  }

  static constexpr int kInside = -2;

  const PartMesh<3>& mesh_;
  std::vector<std::array<std::pair<int, int>, 6>> other_;
  std::vector<std::array<int, 6>> group_;
  std::vector<Upright> upright_;
  std::vector<Column> columns_;
  std::vector<std::array<int, 4>> edge_groups_;
  double low_{}, high_{}, tolerance_{};
};

}  // namespace

std::optional<PartMesh<2>> plate_mid_plane(const PartMesh<3>& mesh) {
  if (mesh.cells.empty()) return std::nullopt;
  return mesh.shape == CellShape::kTensor ? Plate(mesh).mid_plane()
                                          : tetrahedra_mid_plane(mesh);
}

}  // namespace clevis::mesh
