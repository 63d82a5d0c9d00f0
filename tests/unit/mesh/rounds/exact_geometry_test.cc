#include "mesh/rounds/exact_geometry.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "mesh/basis/simplex_basis.h"
#include "mesh/basis/simplex_quadrature.h"
#include "mesh/basis/tensor_basis.h"
#include "mesh/cells/topology.h"
#include "mesh/gmsh/gmsh_reader.h"
#include "mesh/quality/mass_properties.h"
#include "mesh/reading/cells.h"
#include "mesh/rounds/cylinder_fit.h"
#include "mesh/rounds/cylinder_groups.h"
#include "support/source_dir.h"
#include "unit/mesh/mesh_data.h"

namespace clevis::mesh {
namespace {

using Eigen::Vector3d;
constexpr double kPi = std::numbers::pi;

/// Largest distance of a group's mapped faces from its cylinder over the
/// radius, sampled between the nodes.
double off_cylinder(const PartMesh<3>& mesh, const std::string& name) {
  const int group = group_index(mesh, name);
  const part::Bore& bore = *mesh.groups.at(std::size_t(group)).cylinder;
  const auto nodes = gauss_lobatto(mesh.degree);
  const LagrangeBasis fine =
      lagrange(nodes, Eigen::VectorXd::LinSpaced(23, 0.0, 1.0));
  double worst = 0.0;
  for (const BoundaryFace& face : mesh.boundary) {
    if (face.group != group) continue;
    const LagrangeBasis end =
        lagrange(nodes, Eigen::VectorXd::Constant(1, face.face % 2));
    std::array<const LagrangeBasis*, 3> along = {&fine, &fine, &fine};
    along[std::size_t(face.face / 2)] = &end;
    const auto grid =
        map_grid<3>(mesh.cell_points[std::size_t(face.cell)], along);
    for (const auto p : grid.points.colwise()) {
      worst = std::max(worst, (project(bore, p) - p).norm() / bore.radius);
    }
  }
  return worst;
}

TEST(ExactGeometry, CylindersOfAllOrdersAreWithin1e8OfTheRadius) {
  // Facets of 22.5°.
  for (const char* name : {"ring.msh", "ring_order_2.msh", "ring_order_3.msh",
                           "plate_with_bore_41.msh"}) {
    const double worst = off_cylinder(read(name), "bore_A");
    EXPECT_LT(worst, 1e-8) << name;
    EXPECT_GT(worst, 1e-12) << name;  // it is a polynomial after all
  }
  EXPECT_LT(off_cylinder(read("ring.msh"), "round_rim"), 1e-8);
}

TEST(ExactGeometry, FindsTheCylindersOfTheDrawing) {
  for (const char* name :
       {"ring.msh", "ring_order_2.msh", "ring_order_3.msh"}) {
    const PartMesh<3> mesh = read(name);
    const auto& bore =
        *mesh.groups[std::size_t(group_index(mesh, "bore_A"))].cylinder;
    EXPECT_NEAR(bore.radius, 10e-3, 1e-12 * 10e-3) << name;
    EXPECT_NEAR(bore.length, 6e-3, 1e-12 * 6e-3);
    EXPECT_EQ(bore.axis_L, Vector3d::UnitZ());
    EXPECT_LT((bore.p_LC - Vector3d(3e-3, 4e-3, 5e-3)).norm(), 1e-14);
    EXPECT_FALSE(mesh.groups[std::size_t(group_index(mesh, "ends"))].cylinder);
  }
}

TEST(ExactGeometry, NodesOfACylinderLieOnIt) {
  const PartMesh<3> mesh = read("ring_order_2.msh");
  const int group = group_index(mesh, "bore_A");
  const auto& bore = *mesh.groups[std::size_t(group)].cylinder;
  const int n = mesh.degree + 1;
  for (const BoundaryFace& face : mesh.boundary) {
    if (face.group != group) continue;
    for (int q = 0; q < n * n * n; ++q) {
      const std::array<int, 3> i = {q % n, q / n % n, q / (n * n)};
      if (i[std::size_t(face.face / 2)] != (face.face % 2) * (n - 1)) continue;
      const Vector3d p = mesh.cell_points[std::size_t(face.cell)].col(q);
      EXPECT_LT((project(bore, p) - p).norm(), 1e-15 * 10);
    }
  }
}

TEST(ExactGeometry, FlatFacesBesideACylinderStayFlat) {
  const PartMesh<3> mesh = read("ring.msh");
  const int n = mesh.degree + 1, ends = group_index(mesh, "ends");
  for (const BoundaryFace& face : mesh.boundary) {
    if (face.group != ends) continue;
    for (int q = 0; q < n * n * n; ++q) {
      const std::array<int, 3> i = {q % n, q / n % n, q / (n * n)};
      if (i[std::size_t(face.face / 2)] != (face.face % 2) * (n - 1)) continue;
      const double z = mesh.cell_points[std::size_t(face.cell)](2, q);
      EXPECT_LT(std::min(std::abs(z - 2e-3), std::abs(z - 8e-3)), 1e-17);
    }
  }
}

TEST(ExactGeometry, VolumeOfARingConvergesWithTheDegreeOfTheMapping) {
  const GmshFile file = read_gmsh_file(data("ring.msh"));
  const double exact = kPi * (400e-6 - 100e-6) * 6e-3;
  // Faceted, the ring loses 1 - sin(2a)/(2a) of its volume, 2a = 22.5°.
  const PartMesh<3> faceted = build_cells(file, 1e-3);
  const double facet = kPi / 8.0;
  EXPECT_NEAR(mass_properties(faceted, 1.0).mass,
              exact * std::sin(facet) / facet, 1e-13 * exact);
  PartMesh<3> round = faceted;
  fit_cylinder_groups(round, "ring");
  put_on_cylinders(round);
  EXPECT_EQ(round.degree, kCylinderDegree);
  EXPECT_NEAR(mass_properties(round, 1.0).mass, exact, 1e-10 * exact);
}

TEST(ExactGeometry, TurnedAndMovedPartGivesTheSame) {
  GmshFile file = read_gmsh_file(data("plate_with_bore_41.msh"));
  const auto want = mass_properties(read("plate_with_bore_41.msh"), 1000.0);
  const Eigen::Matrix3d R =
      (Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized())).matrix();
  const Vector3d shift(100.0, -50.0, 30.0);
  for (auto& p : file.points) p = R * p + shift;
  PartMesh<3> mesh = build_cells(file, 1e-3);
  fit_cylinder_groups(mesh, "turned");
  put_on_cylinders(mesh);
  const auto got = mass_properties(mesh, 1000.0);
  EXPECT_NEAR(got.mass, want.mass, 1e-12 * want.mass);
  EXPECT_LT((got.p_LCm - (R * want.p_LCm + 1e-3 * shift)).norm(), 1e-14);
  EXPECT_LT((got.inertia_LCm - R * want.inertia_LCm * R.transpose()).norm(),
            1e-11 * want.inertia_LCm.norm());
  const auto& bore =
      *mesh.groups[std::size_t(group_index(mesh, "bore_A"))].cylinder;
  EXPECT_NEAR(std::abs(bore.axis_L.dot(R.col(2))), 1.0, 1e-14);
  EXPECT_NEAR(bore.radius, 5e-3, 1e-12 * 5e-3);
}

/// Fillet radii of a landing-gear part, whose fillets are one facet wide.
std::vector<double> fillet_radii(const std::string& name) {
  const auto file =
      support::source_dir() / "meshes/landing_gear" / (name + ".msh");
  std::vector<double> radii;
  for (const SurfaceGroup& group : read_part_mesh(file, 1e-3).groups) {
    if (group.name.starts_with("round_fillet")) {
      radii.push_back(group.cylinder.value().radius);
    }
  }
  return radii;
}

TEST(ExactGeometry, ARoundOneFacetWideIsTangentToItsNeighbours) {
  // Order 1: two points, between a boss and a flat side; 10 mm by drawing.
  const auto radii = fillet_radii("link_ab");
  EXPECT_EQ(radii.size(), 4u);
  for (const double r : radii) EXPECT_NEAR(r, 10e-3, 1e-12 * 10e-3);
}

TEST(ExactGeometry, ARoundOneFacetWideTakesTheCurvedNodesOfItsFile) {
  // Order 3, beside a loft that is neither flat nor a cylinder; 8 mm.
  const auto radii = fillet_radii("rod");
  EXPECT_EQ(radii.size(), 2u);
  for (const double r : radii) EXPECT_NEAR(r, 8e-3, 1e-11 * 8e-3);
}

/// As off_cylinder, for faces of tetrahedra.
double triangles_off_cylinder(const PartMesh<3>& mesh,
                              const std::string& name) {
  const int group = group_index(mesh, name);
  const part::Bore& bore = *mesh.groups.at(std::size_t(group)).cylinder;
  const auto fine =
      simplex_lagrange<2>(mesh.degree, simplex_gauss<2>(12).points).value;
  double worst = 0.0;
  for (const BoundaryFace& face : mesh.boundary) {
    if (face.group != group) continue;
    const Eigen::Matrix3Xd nodes = mesh.cell_points[std::size_t(face.cell)](
        Eigen::all, simplex_face_lattice<3>(mesh.degree, face.face));
    const Eigen::Matrix3Xd points = nodes * fine.transpose();
    for (const auto p : points.colwise()) {
      worst = std::max(worst, (project(bore, p) - p).norm() / bore.radius);
    }
  }
  return worst;
}

TEST(ExactGeometry, TetrahedraFollowTheCylinder) {
  // Order 1 and 2 in the file; facets of 22.5°.
  for (const char* name :
       {"ring_tetrahedra.msh", "ring_tetrahedra_order_2.msh"}) {
    SCOPED_TRACE(name);
    const PartMesh<3> mesh = read(name);
    EXPECT_EQ(mesh.shape, CellShape::kSimplex);
    EXPECT_EQ(mesh.degree, kSimplexCylinderDegree);
    const auto& bore =
        *mesh.groups[std::size_t(group_index(mesh, "bore_A"))].cylinder;
    EXPECT_NEAR(bore.radius, 10e-3, 1e-14);
    EXPECT_LT(triangles_off_cylinder(mesh, "bore_A"), 1e-6);
    EXPECT_LT(triangles_off_cylinder(mesh, "round_rim"), 1e-6);
    const double volume = kPi * 300e-6 * 6e-3;
    EXPECT_NEAR(mass_properties(mesh, 1.0).mass, volume, 1e-7 * volume);
  }
}

TEST(ExactGeometry, AWideFacetOfAParabolaHasEvenAngles) {
  // A face of one tetrahedron over 84° and 4 mm, as gmsh leaves it.
  const part::Bore cylinder{Vector3d::Zero(), Vector3d::UnitZ(), 10e-3, 20e-3};
  const auto on_it = [](double degrees, double z) {
    const double angle = degrees / 180.0 * kPi;
    return Vector3d(10e-3 * std::cos(angle), 10e-3 * std::sin(angle), z);
  };
  PartMesh<3> mesh;
  mesh.shape = CellShape::kSimplex;
  mesh.degree = 2;
  mesh.vertices = {on_it(0, 0), on_it(84, 0), on_it(40, 4e-3),
                   Vector3d(3e-3, 3e-3, 2e-3)};
  mesh.cells = {{0, 1, 2, 3}};
  const Eigen::Matrix3Xd nodes = simplex_nodes<3>(2);
  Eigen::Matrix3Xd points(3, nodes.cols());
  for (Eigen::Index i = 0; i < nodes.cols(); ++i) {
    const Eigen::Vector4d share(1.0 - nodes.col(i).sum(), nodes(0, i),
                                nodes(1, i), nodes(2, i));
    points.col(i).setZero();
    for (int v = 0; v < 4; ++v) {
      points.col(i) += share[v] * mesh.vertices[std::size_t(v)];
    }
    if (share[3] != 0.0 || share.maxCoeff() > 0.75) continue;
    Eigen::Index from = 0, to = 0;
    share.head<3>().minCoeff(&from);  // the corner across
    to = (from + 1) % 3;
    from = (from + 2) % 3;
    points.col(i) = screw_line(cylinder, mesh.vertices[std::size_t(from)],
                               mesh.vertices[std::size_t(to)], 0.5);
  }
  mesh.cell_points = {points};
  int face = 0;
  while (std::ranges::count(simplex_face<3>(face), 3) > 0) ++face;
  mesh.boundary = {{0, face, 0}};
  mesh.groups = {{"round_1", cylinder}};
  put_on_cylinders(mesh);
  // With nodes where the parabola has them 4.6e-4.
  EXPECT_LT(triangles_off_cylinder(mesh, "round_1"), 1e-4);
}

TEST(ExactGeometry, CurvedTetrahedraShareTheirPoints) {
  const PartMesh<3> mesh = read("ring_tetrahedra_order_2.msh");
  const auto other = neighbours(mesh);
  int shared = 0;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    for (int f = 0; f < 4; ++f) {
      const auto [next, face] = other[c][std::size_t(f)];
      if (next < int(c)) continue;
      const auto here = simplex_face_lattice<3>(mesh.degree, f);
      const auto there = simplex_face_lattice<3>(mesh.degree, face);
      for (const int i : here) {
        double nearest = 1.0;
        for (const int j : there) {
          nearest =
              std::min(nearest, (mesh.cell_points[c].col(i) -
                                 mesh.cell_points[std::size_t(next)].col(j))
                                    .norm());
        }
        EXPECT_LT(nearest, 1e-16);
        ++shared;
      }
    }
  }
  EXPECT_GT(shared, 1000);
}

}  // namespace
}  // namespace clevis::mesh
