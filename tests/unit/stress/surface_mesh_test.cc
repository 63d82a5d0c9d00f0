#include "stress/field/surface_mesh.h"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "elasticity/assembly/supports.h"
#include "stress/field/point_history.h"
#include "support/simplex_mesh.h"
#include "support/structured_mesh.h"

namespace clevis::stress {
namespace {

using Eigen::Vector3d;

const part::Material kSteel{"steel", 200e9, 0.25, 7850.0, 300e6};

/// Box of 3 × 2 × 1 m or rectangle of 3 × 2 m, with a displacement that
/// differs from cell to cell over two instants.
template <int dim>
elasticity::DisplacementBasis<dim> box(mesh::CellShape shape) {
  using Point = Eigen::Matrix<double, dim, 1>;
  const auto map = [](const Point& x) -> Point {
    return x.cwiseProduct(Vector3d(3.0, 2.0, 1.0).head<dim>());
  };
  std::array<int, dim> divisions;
  divisions.fill(2);
  elasticity::DisplacementBasis<dim> basis;
  basis.discretization = elasticity::discretize<dim>(
      shape == mesh::CellShape::kTensor
          ? support::structured_mesh<dim>(divisions, 1, map)
          : support::simplex_mesh<dim>(divisions, 1, map),
      2);
  const auto at = elasticity::node_positions(basis.discretization);
  basis.columns.resize(basis.discretization.dofs(), 2);
  for (Eigen::Index i = 0; i < at.cols(); ++i) {
    for (int d = 0; d < dim; ++d) {
      const double x = at(0, i), y = at(1, i);
      basis.columns(dim * i + d, 0) = 1e-4 * (d + 1) * x * y;
      basis.columns(dim * i + d, 1) = 1e-4 * (x - d * y * y);
    }
  }
  basis.coefficients.resize(2, 3);
  basis.coefficients << 1.0, -2.0, 0.5, 3.0, 1.0, 0.0;
  return basis;
}

Vector3d place(const InstantField& field, const FieldPoint& at) {
  return field.points[std::size_t(at.cell)].row(at.point).transpose();
}

/// Gauss: the volume within outward triangles.
double volume(const InstantField& field, const SurfaceMesh& surface) {
  double sum = 0.0;
  for (const auto& [a, b, c] : surface.triangles) {
    const Vector3d p = place(field, surface.points[std::size_t(a)]);
    const Vector3d q = place(field, surface.points[std::size_t(b)]);
    const Vector3d r = place(field, surface.points[std::size_t(c)]);
    sum += p.dot(q.cross(r)) / 6.0;
  }
  return sum;
}

double area(const InstantField& field, const SurfaceMesh& surface) {
  double sum = 0.0;
  for (const auto& [a, b, c] : surface.triangles) {
    const Vector3d p = place(field, surface.points[std::size_t(a)]);
    sum += 0.5 * (place(field, surface.points[std::size_t(b)]) - p)
                     .cross(place(field, surface.points[std::size_t(c)]) - p)
                     .norm();
  }
  return sum;
}

class SurfaceOf : public testing::TestWithParam<mesh::CellShape> {};
INSTANTIATE_TEST_SUITE_P(Cells, SurfaceOf,
                         testing::Values(mesh::CellShape::kTensor,
                                         mesh::CellShape::kSimplex));

TEST_P(SurfaceOf, ABoxEnclosesItAndHasNoInnerFace) {
  const auto basis = box<3>(GetParam());
  const auto field = instant_field<3>(basis, kSteel, 3, 0);
  const auto surface = surface_mesh<3>(GetParam(), field);
  EXPECT_NEAR(volume(field, surface), 6.0, 1e-12);
  EXPECT_NEAR(area(field, surface), 22.0, 1e-12);
  EXPECT_TRUE(surface.outline.empty());
}

// Green: the area within the outline, counterclockwise.
TEST_P(SurfaceOf, ARectangleHasItsAreaAndItsOutline) {
  const auto basis = box<2>(GetParam());
  const auto field = instant_field<2>(basis, kSteel, 3, 0);
  const auto surface = surface_mesh<2>(GetParam(), field);
  EXPECT_NEAR(area(field, surface), 6.0, 1e-12);
  double enclosed = 0.0, length = 0.0;
  for (const auto& [a, b] : surface.outline) {
    const Vector3d p = place(field, surface.points[std::size_t(a)]);
    const Vector3d q = place(field, surface.points[std::size_t(b)]);
    enclosed += 0.5 * p.cross(q).z();
    length += (q - p).norm();
  }
  EXPECT_NEAR(enclosed, 6.0, 1e-12);
  EXPECT_NEAR(length, 10.0, 1e-12);
}

// Two points at one place with values that differ by 2 or 0.1, and one beside.
TEST(SharePoints, ThatStandAtOnePlaceIfTheirValuesAgree) {
  Eigen::MatrixX3d positions(4, 3);
  positions << 0, 0, 0, 1, 0, 0, 1, 1e-12, 0, 1, 0, 0;
  Eigen::MatrixXd values(4, 2);
  values << 5, 5, 3, 4, 5, 4, 3.1, 4;
  const auto shared = share_points(positions, values, 0.11);
  EXPECT_EQ(shared.number, (std::vector<int>{0, 1, 2, 1}));
  EXPECT_EQ(shared.kept, (std::vector<int>{0, 1, 2}));
  const auto close = share_points(positions, values, 0.09);
  EXPECT_EQ(close.number, (std::vector<int>{0, 1, 2, 3}));
  // Agreement at one instant is not enough.
  values(3, 1) = 9;
  EXPECT_EQ(share_points(positions, values, 0.11).kept.size(), 4U);
}

// A box of cells without jumps: its lattice's own points on the surface.
TEST_P(SurfaceOf, ASmoothFieldSharesAllPoints) {
  const auto basis = box<3>(GetParam());
  const auto field = instant_field<3>(basis, kSteel, 2, 0);
  const auto surface = surface_mesh<3>(GetParam(), field);
  Eigen::MatrixX3d positions(static_cast<Eigen::Index>(surface.points.size()),
                             3);
  for (std::size_t p = 0; p < surface.points.size(); ++p) {
    positions.row(static_cast<Eigen::Index>(p)) =
        place(field, surface.points[p]).transpose();
  }
  const auto shared =
      share_points(positions, Eigen::MatrixXd::Zero(positions.rows(), 1), 0.0);
  // Euler: of a closed surface two more points than half its triangles.
  EXPECT_EQ(shared.kept.size(), surface.triangles.size() / 2 + 2);
}

template <int dim>
void expect_fields_of_instants(mesh::CellShape shape) {
  const auto basis = box<dim>(shape);
  const std::vector<int> instants{2, 1};
  const auto first = instant_field<dim>(basis, kSteel, 3, 0);
  const auto surface = surface_mesh<dim>(shape, first);
  const auto history =
      point_history<dim>(basis, kSteel, 3, surface.points, instants);
  const auto points = static_cast<Eigen::Index>(surface.points.size());
  ASSERT_EQ(history.von_mises.rows(), points);
  for (Eigen::Index i = 0; i < 2; ++i) {
    const auto field =
        instant_field<dim>(basis, kSteel, 3, instants[std::size_t(i)]);
    for (Eigen::Index p = 0; p < points; ++p) {
      const FieldPoint& at = surface.points[std::size_t(p)];
      const auto cell = std::size_t(at.cell);
      EXPECT_NEAR(history.von_mises(p, i),
                  von_mises(field.stress[cell])[at.point], 1e-3);
      for (int d = 0; d < dim; ++d) {
        EXPECT_NEAR(history.displacement(p + d * points, i),
                    field.displacement[cell](at.point, d), 1e-15);
      }
    }
  }
}

TEST_P(SurfaceOf, PointHistoriesAreTheFieldsOfTheInstants) {
  expect_fields_of_instants<2>(GetParam());
  expect_fields_of_instants<3>(GetParam());
}

// On the middle of an edge, inside a face, on a corner of a square of eight by
// eight: the nearest of three by three that lies on the same.
TEST(StandIn, LiesOnTheSamePieceOfTheCell) {
  const auto at = [](int n, int i, int j) {
    return i + (n + 1) * j;
  };
  const auto shape = mesh::CellShape::kTensor;
  EXPECT_EQ(stand_in<2>(shape, 8, at(8, 1, 0), 3), at(3, 1, 0));
  EXPECT_EQ(stand_in<2>(shape, 8, at(8, 8, 7), 3), at(3, 3, 2));
  EXPECT_EQ(stand_in<2>(shape, 8, at(8, 7, 1), 3), at(3, 2, 1));
  EXPECT_EQ(stand_in<2>(shape, 8, at(8, 0, 8), 3), at(3, 0, 3));
}

// What stands on the oblique face stays there, though a point inside may be as
// near; on a lattice without points inside the border stands in.
TEST(StandIn, LiesOnTheFacesOfATetrahedron) {
  constexpr double kRoundOff = 1e-12;
  const auto shape = mesh::CellShape::kSimplex;
  const auto fine = elasticity::lattice<3>(shape, 8);
  for (const int to : {2, 3, 4}) {
    const auto coarse = elasticity::lattice<3>(shape, to);
    for (Eigen::Index i = 0; i < fine.cols(); ++i) {
      const Eigen::Vector3d there =
          coarse.col(stand_in<3>(shape, 8, static_cast<int>(i), to));
      if (std::abs(1.0 - fine.col(i).sum()) < kRoundOff) {
        EXPECT_NEAR(there.sum(), 1.0, kRoundOff) << i << " on " << to;
      }
      for (int d = 0; d < 3; ++d) {
        if (fine(d, i) < kRoundOff) {
          EXPECT_NEAR(there[d], 0.0, kRoundOff) << i << " on " << to;
        }
      }
      EXPECT_LE((there - fine.col(i)).norm(), std::sqrt(3.0) / to);
    }
  }
}

}  // namespace
}  // namespace clevis::stress
