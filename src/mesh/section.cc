#include "mesh/section.h"

#include <array>
#include <numeric>

#include <Eigen/Dense>

#include "mesh/tensor_basis.h"
#include "mesh/topology.h"

namespace clevis::mesh {

namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

/// Subdivisions of a cell per direction.
constexpr int kParts = 4;

/// The six tetrahedra of a cube around its diagonal, by corner bits.
constexpr std::array<std::array<int, 4>, 6> kTetrahedra = {{{0, 1, 3, 7},
                                                            {0, 1, 5, 7},
                                                            {0, 2, 3, 7},
                                                            {0, 2, 6, 7},
                                                            {0, 4, 5, 7},
                                                            {0, 4, 6, 7}}};

struct Plane {
  Vector3d point, normal;
  double height(const Vector3d& p) const { return (p - point).dot(normal); }
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

/// Collects the polygons of a section.
class Sum {
 public:
  explicit Sum(const Plane& plane) : plane_(plane) {}

  void add_tetrahedron(const std::array<Vector3d, 4>& p) {
    std::array<double, 4> h{};
    std::array<std::size_t, 4> up{}, down{};
    std::size_t ups = 0, downs = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      h[i] = plane_.height(p[i]);
      if (Cut::above(h[i])) {
        up[ups++] = i;
      } else {
        down[downs++] = i;
      }
    }
    const auto meet = [&](std::size_t a, std::size_t b) {
      return Cut::at(p[a], h[a], p[b], h[b]);
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

bool crosses(const Matrix3Xd& points, const Plane& plane) {
  bool above = false, below = false;
  for (Index i = 0; i < points.cols(); ++i) {
    (Cut::above(plane.height(points.col(i))) ? above : below) = true;
  }
  return above && below;
}

/// Even points of a hexahedron, (kParts + 1)³ lexicographic.
class Subdivision {
 public:
  explicit Subdivision(int degree)
      : basis_(lagrange(gauss_lobatto(degree),
                        Eigen::VectorXd::LinSpaced(kParts + 1, 0.0, 1.0))
                   .value) {}

  Matrix3Xd points(const Matrix3Xd& cell_points) const {
    return interpolate<3>(cell_points, {&basis_, &basis_, &basis_});
  }
  static Index index(int i, int j, int k) {
    return i + (kParts + 1) * (j + Index(kParts + 1) * k);
  }
  /// The even points of local face `face`, (kParts + 1)².
  static Matrix3Xd on_face(const Matrix3Xd& points, int face) {
    Matrix3Xd on(3, (kParts + 1) * (kParts + 1));
    std::array<int, 3> i{};
    const auto d = std::size_t(face / 2);
    i[d] = (face % 2) * kParts;
    Index q = 0;
    for (int a = 0; a <= kParts; ++a) {
      for (int b = 0; b <= kParts; ++b) {
        i[(d + 1) % 3] = b;
        i[(d + 2) % 3] = a;
        on.col(q++) = points.col(index(i[0], i[1], i[2]));
      }
    }
    return on;
  }

 private:
  Eigen::MatrixXd basis_;
};

void add_hexahedron(const Matrix3Xd& points, Sum& sum) {
  for (int k = 0; k < kParts; ++k) {
    for (int j = 0; j < kParts; ++j) {
      for (int i = 0; i < kParts; ++i) {
        for (const auto& tetrahedron : kTetrahedra) {
          std::array<Vector3d, 4> corners;
          for (std::size_t v = 0; v < 4; ++v) {
            const int bits = tetrahedron[v];
            corners[v] = points.col(Subdivision::index(
                i + (bits & 1), j + (bits >> 1 & 1), k + (bits >> 2 & 1)));
          }
          sum.add_tetrahedron(corners);
        }
      }
    }
  }
}

/// Points where the grid lines of a boundary face meet the plane.
void add_rim(const Matrix3Xd& on_face, const Plane& plane,
             std::vector<Vector3d>& rim) {
  const auto meet = [&](Index a, Index b) {
    const double ha = plane.height(on_face.col(a));
    const double hb = plane.height(on_face.col(b));
    if (Cut::above(ha) == Cut::above(hb)) return;
    rim.push_back(Cut::at(on_face.col(a), ha, on_face.col(b), hb));
  };
  constexpr Index kRow = kParts + 1;
  for (Index j = 0; j < kRow; ++j) {
    for (Index i = 0; i < kParts; ++i) {
      meet(i + kRow * j, i + 1 + kRow * j);
      meet(j + kRow * i, j + kRow * (i + 1));
    }
  }
}

int count_pieces(const PartMesh<3>& mesh, const std::vector<Matrix3Xd>& cut,
                 const Plane& plane) {
  const auto other = neighbours(mesh);
  const auto face_is_cut = [&](std::size_t cell, int face) {
    if (mesh.shape == CellShape::kTensor) {
      return crosses(Subdivision::on_face(cut[cell], face), plane);
    }
    const FaceVertices v = face_vertices(mesh, int(cell), face);
    Matrix3d corners;
    corners << mesh.vertices[v[0]], mesh.vertices[v[1]], mesh.vertices[v[2]];
    return crosses(corners, plane);
  };
  std::vector<bool> seen(cut.size(), false);
  int pieces = 0;
  for (std::size_t seed = 0; seed < cut.size(); ++seed) {
    if (seen[seed] || cut[seed].cols() == 0) continue;
    ++pieces;
    std::vector<std::size_t> front = {seed};
    seen[seed] = true;
    while (!front.empty()) {
      const std::size_t cell = front.back();
      front.pop_back();
      for (int face = 0; face < faces_per_cell(mesh.shape); ++face) {
        const int next = other[cell][std::size_t(face)].first;
        if (next < 0 || seen[std::size_t(next)] ||
            cut[std::size_t(next)].cols() == 0 || !face_is_cut(cell, face)) {
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

Section cut(const PartMesh<3>& mesh, const Vector3d& point,
            const Vector3d& normal) {
  const Plane plane{point, normal.normalized()};
  const Subdivision subdivision(mesh.degree);
  const bool tensor = mesh.shape == CellShape::kTensor;
  Section section;
  Sum sum(plane);
  std::vector<Matrix3Xd> cut_cells(mesh.cells.size());  // empty: not cut
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    // The points of a curved cell reach beyond its corners: take all.
    if (!crosses(mesh.cell_points[c], plane)) continue;
    if (!tensor) {
      cut_cells[c] = mesh.cell_points[c];
      sum.add_tetrahedron(
          {mesh.cell_points[c].col(0), mesh.cell_points[c].col(1),
           mesh.cell_points[c].col(2), mesh.cell_points[c].col(3)});
      continue;
    }
    cut_cells[c] = subdivision.points(mesh.cell_points[c]);
    add_hexahedron(cut_cells[c], sum);
  }
  sum.finish(section);
  for (const BoundaryFace& face : mesh.boundary) {
    const Matrix3Xd& cell = cut_cells[std::size_t(face.cell)];
    if (cell.cols() == 0) continue;
    if (tensor) {
      add_rim(Subdivision::on_face(cell, face.face), plane, section.rim);
      continue;
    }
    const FaceVertices v = face_vertices(mesh, face.cell, face.face);
    for (int a = 0; a < 3; ++a) {
      const Vector3d &p = mesh.vertices[v[std::size_t(a)]],
                     &q = mesh.vertices[v[std::size_t((a + 1) % 3)]];
      const double hp = plane.height(p), hq = plane.height(q);
      if (Cut::above(hp) == Cut::above(hq)) continue;
      section.rim.push_back(Cut::at(p, hp, q, hq));
    }
  }
  section.pieces = count_pieces(mesh, cut_cells, plane);
  return section;
}

}  // namespace clevis::mesh
