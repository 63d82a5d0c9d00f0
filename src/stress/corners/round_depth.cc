#include "stress/corners/round_depth.h"

#include <algorithm>

#include "stress/corners/boundary_corner.h"

namespace clevis::stress {
double depth_over_radius(const mesh::PartMesh<3>& mesh,
                         const Eigen::Vector3d& at) {
  constexpr double kTurns = 0.05;  // [rad]; less is a plane
  double largest = 0.0;
  for (const BoundaryCorner& corner : boundary_corners<3>(mesh)) {
    for (const CornerSide& side : corner.sides) {
      if (!(side.turn > kTurns)) continue;
      const double radius = side.extent / side.turn;
      const double away =
          distance_from_edge(at, mesh.vertices[corner.vertices[0]],
                             mesh.vertices[corner.vertices[1]]);
      if (away > side.extent + radius) continue;
      largest = std::max(largest, corner.reach / radius);
    }
  }
  return largest;
}

}  // namespace clevis::stress
