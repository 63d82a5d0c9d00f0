#include "mesh/quality/simplex_quality.h"

#include <random>

#include <Eigen/LU>
#include <gtest/gtest.h>

namespace clevis::mesh {
namespace {

using Eigen::Matrix3Xd;

/// The reference tetrahedron of a degree, its nodes moved by up to `size`.
Matrix3Xd shaken(int degree, double size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> step(-size, size);
  Matrix3Xd points = simplex_nodes<3>(degree);
  for (auto& x : points.reshaped()) x += step(random);
  return points;
}

/// Smallest determinant on a fine lattice.
double sampled_minimum(int degree, const Matrix3Xd& points) {
  const auto lattice = simplex_lattice<3>(12);
  SimplexPoints<3> at(3, Eigen::Index(lattice.size()));
  for (std::size_t i = 0; i < lattice.size(); ++i) {
    for (std::size_t d = 0; d < 3; ++d) {
      at(Eigen::Index(d), Eigen::Index(i)) = lattice[i][d + 1] / 12.0;
    }
  }
  const auto grid = map_simplex<3>(points, simplex_lagrange<3>(degree, at));
  double lowest = 1e300;
  for (Eigen::Index q = 0; q < at.cols(); ++q) {
    lowest = std::min(lowest, grid.jacobian(q).determinant());
  }
  return lowest;
}

TEST(SimplexQuality, NoFoldedCellPassesAndHardlyAnySoundOneIsRefused) {
  for (int degree = 1; degree <= 4; ++degree) {
    const SimplexQuality quality(degree);
    int sound = 0, folded = 0, refused = 0;
    for (unsigned seed = 0; seed < 150; ++seed) {
      const Matrix3Xd points =
          shaken(degree, 1.2 * seed / 150.0 / (degree * degree), seed);
      const double sampled = sampled_minimum(degree, points);
      const double bound = quality.of(points).min_jacobian;
      // Between the samples the determinant may be lower still, never above.
      EXPECT_TRUE(sampled > 0.0 || bound <= 0.0) << degree << ' ' << seed;
      EXPECT_TRUE(bound <= 0.0 || bound <= sampled * (1.0 + 1e-9));
      (sampled > 0.0 ? sound : folded) += 1;
      refused += sampled > 5e-2 && !(bound > 0.0);
    }
    EXPECT_GT(sound, 20);
    EXPECT_TRUE(degree == 1 || folded > 20);
    EXPECT_EQ(refused, 0) << degree;
  }
}

TEST(SimplexQuality, AFoldBetweenTheNodesIsSeen) {
  // A middle node far along its edge: positive at all four corners of the
  // straight tetrahedron, negative near one end of the edge.
  Matrix3Xd points = simplex_nodes<3>(2);
  points.col(1) = Eigen::Vector3d(0.8, 0.0, 0.0);  // middle of edge 01
  EXPECT_LE(SimplexQuality(2).of(points).min_jacobian, 0.0);
  points.col(1) = Eigen::Vector3d(0.7, 0.0, 0.0);
  EXPECT_GT(SimplexQuality(2).of(points).min_jacobian, 0.0);
}

}  // namespace
}  // namespace clevis::mesh
