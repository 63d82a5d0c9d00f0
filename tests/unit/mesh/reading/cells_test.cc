#include "mesh/reading/cells.h"

#include <cmath>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "mesh/basis/tensor_basis.h"
#include "mesh/cells/topology.h"
#include "mesh/gmsh/gmsh_reader.h"
#include "mesh/quality/mass_properties.h"
#include "mesh/quality/mesh_validation.h"
#include "mesh/rounds/cylinder_groups.h"
#include "mesh/rounds/exact_geometry.h"
#include "unit/mesh/mesh_data.h"

namespace clevis::mesh {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

/// A map of degree `order` in each coordinate of the box [0, 2] × [0, 1]²;
/// not symmetric in anything, so that no two nodes can change places.
Vector3d bend(const Vector3d& p, int order) {
  const double x = p.x(), y = p.y(), z = p.z();
  return {x + 0.05 * std::pow(x, order) * y + 0.03 * std::pow(z, order),
          y + 0.04 * x * std::pow(y, order) * std::pow(z, order),
          z + 0.02 * std::pow(x, order) * std::pow(y, order) + 0.01 * y * z};
}

/// Trilinear position of the Gauss–Lobatto points of a cell.
Matrix3Xd straight_points(const PartMesh<3>& mesh, std::size_t cell) {
  Matrix3Xd corners(3, 8);
  for (std::size_t v = 0; v < 8; ++v) {
    corners.col(Eigen::Index(v)) = mesh.vertices[mesh.cells[cell][v]];
  }
  const Eigen::MatrixXd up =
      lagrange(gauss_lobatto(1), gauss_lobatto(mesh.degree)).value;
  return interpolate<3>(corners, {&up, &up, &up});
}

/// The box without the 1e-12 by which gmsh misses its lattice.
GmshFile box(const std::string& name) {
  GmshFile file = read_gmsh_file(data(name));
  for (auto& p : file.points) p = (12.0 * p).array().round().matrix() / 12.0;
  return file;
}

void expect_bent(const GmshFile& straight, int order, int map_order) {
  const PartMesh<3> flat = build_cells(straight, 1.0);
  GmshFile bent = straight;
  for (auto& p : bent.points) p = bend(p, map_order);
  const PartMesh<3> mesh = build_cells(bent, 1.0);
  ASSERT_EQ(mesh.degree, order);
  ASSERT_EQ(mesh.cells, flat.cells);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    Matrix3Xd want = straight_points(flat, c);
    for (auto column : want.colwise()) column = bend(column, map_order);
    EXPECT_LT((mesh.cell_points[c] - want).cwiseAbs().maxCoeff(), 1e-14)
        << "order " << order;
  }
}

TEST(Cells, GmshNodeOrderReproducesAPolynomialMap) {
  for (int order = 1; order <= 4; ++order) {
    expect_bent(box("box_order_" + std::to_string(order) + ".msh"), order,
                order);
  }
}

TEST(Cells, SerendipityIsExactForTheQuadraticsThatItHolds) {
  const GmshFile file = box("box_serendipity.msh");
  EXPECT_EQ(file.elements.back().type->nodes, 20);
  // x² y z and the like are in the space: superlinear degree two.
  expect_bent(file, 2, 1);
  GmshFile bent = file;
  const auto map = [](const Vector3d& p) {
    return Vector3d(p.x() + 0.1 * p.x() * p.x() * p.y() * p.z(),
                    p.y() + 0.2 * p.x() * p.y() * p.y(),
                    p.z() + 0.1 * p.z() * p.z() - 0.1 * p.x() * p.x());
  };
  for (auto& p : bent.points) p = map(p);
  const PartMesh<3> flat = build_cells(file, 1.0);
  const PartMesh<3> mesh = build_cells(bent, 1.0);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    Matrix3Xd want = straight_points(flat, c);
    for (auto column : want.colwise()) column = map(column);
    EXPECT_LT((mesh.cell_points[c] - want).cwiseAbs().maxCoeff(), 1e-14);
  }
}

/// Points of a local face, sorted along an arbitrary direction.
std::vector<Vector3d> sorted_face_points(const PartMesh<3>& mesh, int cell,
                                         int face) {
  const int n = mesh.degree + 1;
  std::vector<Vector3d> points;
  for (int q = 0; q < n * n * n; ++q) {
    const std::array<int, 3> i = {q % n, q / n % n, q / (n * n)};
    if (i[std::size_t(face / 2)] == (face % 2) * mesh.degree) {
      points.push_back(mesh.cell_points[std::size_t(cell)].col(q));
    }
  }
  const Vector3d odd(0.317, 0.551, 0.777);
  std::sort(points.begin(), points.end(), [&](const auto& a, const auto& b) {
    return odd.dot(a) < odd.dot(b);
  });
  return points;
}

void expect_conforming(const PartMesh<3>& mesh) {
  const auto other = neighbours(mesh);
  int shared = 0;
  for (int cell = 0; cell < int(mesh.cells.size()); ++cell) {
    for (int face = 0; face < 6; ++face) {
      const auto [next, next_face] =
          other[std::size_t(cell)][std::size_t(face)];
      if (next < cell) continue;
      const auto a = sorted_face_points(mesh, cell, face);
      const auto b = sorted_face_points(mesh, next, next_face);
      for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_LT((a[i] - b[i]).norm(), 1e-16) << cell << ' ' << face;
      }
      ++shared;
    }
  }
  EXPECT_GT(shared, 0);
}

TEST(Cells, NeighboursHaveTheSamePointsOnTheirFace) {
  for (const char* name : {"ring.msh", "ring_order_2.msh", "ring_order_3.msh",
                           "plate_with_bore_41.msh", "box_order_4.msh"}) {
    SCOPED_TRACE(name);
    expect_conforming(read(name));
  }
}

/// The 24 ways to lay right-handed axes into a cube.
struct Rotation {
  std::array<int, 3> axis{};
  std::array<bool, 3> reverse{};
};

std::vector<Rotation> rotations() {
  std::vector<Rotation> all;
  std::array<int, 3> axis = {0, 1, 2};
  int odd_axes = 0;
  do {
    odd_axes = (axis[0] > axis[1]) + (axis[0] > axis[2]) + (axis[1] > axis[2]);
    for (int bits = 0; bits < 8; ++bits) {
      const Rotation r{axis,
                       {(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0}};
      const int reversed = r.reverse[0] + r.reverse[1] + r.reverse[2];
      if ((odd_axes + reversed) % 2 == 0) all.push_back(r);
    }
  } while (std::next_permutation(axis.begin(), axis.end()));
  return all;
}

/// Renumbers the nodes of one element of gmsh as if it had been rotated.
void rotate(GmshFile& file, const GmshElement& element, const Rotation& r) {
  const int order = element.type->order, n = order + 1;
  const auto index = hexahedron_node_order(order);
  std::map<int, int> node_at;
  for (std::size_t a = 0; a < index.size(); ++a) node_at[index[a]] = int(a);
  std::vector<unsigned> turned;
  for (const int i : index) {
    const std::array<int, 3> from = {i % n, i / n % n, i / (n * n)};
    std::array<int, 3> to{};
    for (std::size_t d = 0; d < 3; ++d) {
      to[std::size_t(r.axis[d])] = r.reverse[d] ? order - from[d] : from[d];
    }
    const int old = node_at.at(to[0] + n * (to[1] + n * to[2]));
    turned.push_back(file.element_nodes[element.first_node + std::size_t(old)]);
  }
  std::copy(turned.begin(), turned.end(),
            file.element_nodes.begin() + std::ptrdiff_t(element.first_node));
}

PartMesh<3> finished(const GmshFile& file) {
  PartMesh<3> mesh = build_cells(file, 1e-3);
  fit_cylinder_groups(mesh, file.name);
  put_on_cylinders(mesh);
  check_jacobians(mesh, file.name);
  return mesh;
}

TEST(Cells, TheNumberingOfAHexahedronDoesNotMatter) {
  const auto all = rotations();
  ASSERT_EQ(all.size(), 24u);
  for (const char* name : {"ring.msh", "ring_order_2.msh"}) {
    const GmshFile original = read_gmsh_file(data(name));
    const auto want = mass_properties(finished(original), 7850.0);
    std::mt19937 random(7);
    for (const Rotation& first : all) {
      GmshFile file = original;
      for (const GmshElement& element : file.elements) {
        if (element.type->dim == 3) {
          rotate(file, element, all[random() % 24]);
        }
      }
      rotate(file, file.elements.back(), first);
      const PartMesh<3> mesh = finished(file);
      expect_conforming(mesh);
      const auto got = mass_properties(mesh, 7850.0);
      EXPECT_NEAR(got.mass, want.mass, 1e-14 * want.mass);
      EXPECT_LT((got.inertia_LCm - want.inertia_LCm).norm(),
                1e-13 * want.inertia_LCm.norm());
    }
  }
}

TEST(Cells, SharedEdgesPointTheSameWay) {
  GmshFile file = read_gmsh_file(data("plate_with_bore_41.msh"));
  const auto all = rotations();
  std::mt19937 random(11);
  for (const GmshElement& element : file.elements) {
    if (element.type->dim == 3) rotate(file, element, all[random() % 24]);
  }
  const PartMesh<3> mesh = build_cells(file, 1e-3);
  std::map<std::pair<unsigned, unsigned>, int> seen;
  for (const auto& cell : mesh.cells) {
    for (const HexEdge& edge : hex_edges()) {
      const unsigned from = cell[std::size_t(edge.from)];
      const unsigned to = cell[std::size_t(edge.to)];
      ++seen[{from, to}];
      EXPECT_FALSE(seen.contains({to, from}));
    }
  }
  EXPECT_LT(seen.size(), 12 * mesh.cells.size());
  EXPECT_NO_THROW(check_jacobians(mesh, "turned"));
}

TEST(Cells, QualityOfABoxIsOne) {
  for (const CellQuality& q :
       cell_qualities(build_cells(box("box_order_3.msh"), 1e-3))) {
    EXPECT_NEAR(q.scaled_jacobian, 1.0, 1e-13);
    EXPECT_NEAR(q.min_jacobian, 1e-9, 1e-21);  // cells of 1 mm
    EXPECT_NEAR(q.max_jacobian, 1e-9, 1e-21);
  }
}

}  // namespace
}  // namespace clevis::mesh
