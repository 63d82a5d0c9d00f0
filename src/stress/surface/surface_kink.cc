#include "stress/surface/surface_kink.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <Eigen/Geometry>

#include "elasticity/fe_space/tabulation.h"
#include "stress/field/stress_history.h"
#include "stress/surface/surface_edge.h"

namespace clevis::stress {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;

/// Stress of some cells along their edges.
class EdgeStress {
 public:
  EdgeStress(const mesh::PartMesh<3>& mesh, const std::vector<int>& cells,
             const std::vector<MatrixXd>& stress)
      : mesh_(mesh),
        lattice_(elasticity::lattice<3>(mesh.shape, kEdgeIntervals)),
        stress_(stress) {
    for (std::size_t k = 0; k < cells.size(); ++k) place_[cells[k]] = k;
  }

  /// The stress that flows across the edge in the surface, at each of the
  /// edge's points [Pa]; 0 in other cells.
  Eigen::ArrayXd across(const EdgeSide& side) const {
    Eigen::ArrayXd across = Eigen::ArrayXd::Zero(kEdgeIntervals + 1);
    const auto face = static_cast<std::size_t>(side.face);
    const auto known = place_.find(mesh_.boundary[face].cell);
    if (known == place_.end()) return across;
    for (Index k = 0; k < across.size(); ++k) {
      const Matrix3d stress =
          stress_tensor(stress_[known->second].row(row(side, k)));
      const Vector3d direction =
          side.normal.col(k).cross(side.along.col(k)).normalized();
      across[k] = std::abs(direction.dot(stress * direction));
    }
    return across;
  }

 private:
  /// Of the lattice, at a point of the edge.
  Index row(const EdgeSide& side, Index point) const {
    Index row = 0;
    (lattice_.colwise() - side.points.col(point))
        .colwise()
        .squaredNorm()
        .minCoeff(&row);
    return row;
  }

  const mesh::PartMesh<3>& mesh_;
  elasticity::ReferencePoints<3> lattice_;
  const std::vector<MatrixXd>& stress_;
  std::map<int, std::size_t> place_;
};

}  // namespace

double kinked_stress(const mesh::PartMesh<3>& mesh,
                     const std::vector<int>& cells,
                     const std::vector<MatrixXd>& stress) {
  std::vector<char> is_near(mesh.vertices.size(), 0);
  for (const int cell : cells) {
    for (const unsigned v : mesh.cells[static_cast<std::size_t>(cell)]) {
      is_near[v] = 1;
    }
  }
  const EdgeStress field(mesh, cells, stress);
  double largest = 0.0;
  for (const SurfaceEdge& edge : smooth_edges(mesh, is_near)) {
    const Eigen::ArrayXd across =
        field.across(edge.one).max(field.across(edge.other));
    largest = std::max(largest, (edge.kink * across).maxCoeff());
  }
  return largest;
}

}  // namespace clevis::stress
