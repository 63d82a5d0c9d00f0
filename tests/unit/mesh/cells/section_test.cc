#include "mesh/cells/section.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "unit/mesh/mesh_data.h"

namespace clevis::mesh {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
constexpr double kPi = std::numbers::pi;

TEST(Section, RectangleIsExactAlsoOnAMeshPlane) {
  const PartMesh<3> box = read("box_order_3.msh");
  for (const double x : {0.3e-3, 1e-3, 1.7e-3}) {  // 1 mm: between two cells
    const Section s = cut(box, {x, 0.0, 0.0}, {2.0, 0.0, 0.0});
    EXPECT_NEAR(s.area, 1e-6, 1e-18) << x;
    EXPECT_LT((s.centroid - Vector3d(x, 0.5e-3, 0.5e-3)).norm(), 1e-16);
    const Matrix3d want =
        Vector3d(0.0, 1e-12 / 12, 1e-12 / 12).asDiagonal().toDenseMatrix();
    EXPECT_LT((s.second_moment - want).norm(), 1e-24);
    EXPECT_EQ(s.pieces, 1);
  }
}

// Cells that share nodes on the plane have them apart by round-off: some above,
// some below it.
TEST(Section, RoundOffOfNodesOnThePlaneIsNone) {
  constexpr double kRoundOff = 1e-18;
  PartMesh<3> box = read("box_order_3.msh");
  for (std::size_t c = 0; c < box.cell_points.size(); ++c) {
    auto& points = box.cell_points[c];
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
      points(0, i) +=
          kRoundOff *
          (static_cast<double>((static_cast<std::size_t>(i) + 2 * c) % 3) -
           1.0);
    }
  }
  const Section s = cut(box, {1e-3, 0.0, 0.0}, {1.0, 0.0, 0.0});
  EXPECT_NEAR(s.area, 1e-6, 1e-15);
  EXPECT_EQ(s.pieces, 1);
}

TEST(Section, ObliqueCutOfABox) {
  const PartMesh<3> box = read("box_order_1.msh");
  const Section s = cut(box, {1e-3, 0.5e-3, 0.5e-3}, {1.0, 1.0, 0.0});
  // 1 mm high, √2 mm wide; second moment along (-1, 1)/√2: b³ h / 12.
  EXPECT_NEAR(s.area, std::sqrt(2.0) * 1e-6, 1e-17);
  const Vector3d along = Vector3d(-1.0, 1.0, 0.0).normalized();
  EXPECT_NEAR(along.dot(s.second_moment * along),
              std::pow(2.0, 1.5) * 1e-12 / 12.0, 1e-23);
  EXPECT_LT((s.centroid - Vector3d(1e-3, 0.5e-3, 0.5e-3)).norm(), 1e-16);
}

TEST(Section, RingAcrossItsAxis) {
  const Section s =
      cut(read("ring.msh"), {3e-3, 4e-3, 4.1e-3}, Vector3d::UnitZ());
  const double area = kPi * 300e-6;
  const double second = kPi / 4.0 * (160000e-12 - 10000e-12);
  EXPECT_NEAR(s.area, area, 3e-3 * area);
  EXPECT_LT((s.centroid - Vector3d(3e-3, 4e-3, 4.1e-3)).norm(), 1e-12);
  EXPECT_NEAR(s.second_moment(0, 0), second, 5e-3 * second);
  EXPECT_NEAR(s.second_moment(1, 1), second, 5e-3 * second);
  EXPECT_LT(std::abs(s.second_moment(2, 2)), 1e-9 * second);
  EXPECT_EQ(s.pieces, 1);
  // Extreme fibres: on one of the two circles.
  double far = 0.0;
  for (const Vector3d& p : s.rim) {
    const double r = (p - s.centroid).norm();
    EXPECT_LT(std::min(std::abs(r - 10e-3), std::abs(r - 20e-3)), 20e-3 * 5e-4);
    far = std::max(far, r);
  }
  EXPECT_NEAR(far, 20e-3, 1e-8);
  const Section fine =
      cut(read("ring.msh"), {3e-3, 4e-3, 4.1e-3}, Vector3d::UnitZ(), 12);
  EXPECT_NEAR(fine.area, area, 3e-3 / 9.0 * area);
  EXPECT_NEAR(fine.second_moment(0, 0), second, 5e-3 / 9.0 * second);
}

TEST(Section, ABoreSplitsAPlateInTwo) {
  const PartMesh<3> plate = read("plate_with_bore_41.msh");
  const Section through = cut(plate, Vector3d::Zero(), Vector3d::UnitX());
  EXPECT_EQ(through.pieces, 2);
  EXPECT_NEAR(through.area, 120e-6, 1e-16);  // (40 - 10) × 4
  EXPECT_LT((through.centroid - Vector3d(0.0, 0.0, 2e-3)).norm(), 1e-15);
  const double second = (64000.0 - 1000.0) * 4.0 / 12.0 * 1e-12;
  EXPECT_NEAR(through.second_moment(1, 1), second, 1e-12 * second);

  const Section beside = cut(plate, {7e-3, 0.0, 0.0}, Vector3d::UnitX());
  EXPECT_EQ(beside.pieces, 1);
  EXPECT_NEAR(beside.area, 160e-6, 1e-16);

  const double x = 3e-3, gap = 2.0 * 4e-3;  // chord of the bore at 3 mm
  const Section chord = cut(plate, {x, 0.0, 0.0}, Vector3d::UnitX());
  EXPECT_EQ(chord.pieces, 2);
  EXPECT_NEAR(chord.area, (40e-3 - gap) * 4e-3, 3e-3 * chord.area);
}

TEST(Section, TetrahedraAndMisses) {
  const PartMesh<3> ring = read("ring_tetrahedra.msh");
  const Section s = cut(ring, {3e-3, 4e-3, 4.1e-3}, Vector3d::UnitZ());
  EXPECT_NEAR(s.area, kPi * 300e-6, 3e-3 * s.area);
  EXPECT_EQ(s.pieces, 1);
  EXPECT_EQ(cut(ring, {3e-3, 4e-3, 4.1e-3}, Vector3d::UnitX()).pieces, 2);
  const Section miss = cut(ring, {0.0, 0.0, 1.0}, Vector3d::UnitZ());
  EXPECT_EQ(miss.area, 0.0);
  EXPECT_EQ(miss.pieces, 0);
  EXPECT_TRUE(miss.rim.empty());
}

}  // namespace
}  // namespace clevis::mesh
