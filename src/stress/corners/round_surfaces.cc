#include "stress/corners/round_surfaces.h"

#include "mesh/cells/topology.h"

namespace clevis::stress {
namespace {

using Eigen::Vector3d;

Vector3d on_cylinder(const part::Bore& bore, const Vector3d& point) {
  const Vector3d arm = point - bore.p_LC;
  const Vector3d along = bore.axis_L.dot(arm) * bore.axis_L;
  return bore.p_LC + along + bore.radius * (arm - along).normalized();
}

/// Appends the points between each two corners of a facet, corners included.
void add_points(const part::Bore& bore, const std::vector<Vector3d>& corners,
                std::vector<Vector3d>& points) {
  constexpr int kPieces = 8;
  points.insert(points.end(), corners.begin(), corners.end());
  for (std::size_t a = 0; a < corners.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      for (int k = 1; k < kPieces; ++k) {
        const double t = static_cast<double>(k) / kPieces;
        points.push_back(
            on_cylinder(bore, (1.0 - t) * corners[a] + t * corners[b]));
      }
    }
  }
}

}  // namespace

template <int dim>
Vector3d position(const mesh::PartMesh<dim>& mesh, unsigned vertex) {
  Vector3d result(0.0, 0.0, mesh.mid_plane_z);
  result.head<dim>() = mesh.vertices[vertex];
  return result;
}

template <int dim>
std::vector<RoundSurface> round_surfaces(const mesh::PartMesh<dim>& mesh) {
  std::vector<RoundSurface> result(mesh.groups.size());
  for (const mesh::BoundaryFace& face : mesh.boundary) {
    if (face.group < 0) continue;
    const auto g = static_cast<std::size_t>(face.group);
    if (!mesh.groups[g].cylinder) continue;
    std::vector<Vector3d> corners;
    for (const unsigned v : mesh::face_vertices(mesh, face.cell, face.face)) {
      if (v == mesh::kNoVertex) continue;
      result[g].vertices.insert(v);
      corners.push_back(position(mesh, v));
    }
    add_points(*mesh.groups[g].cylinder, corners, result[g].points);
  }
  std::erase_if(result, [](const RoundSurface& surface) {
    return surface.vertices.empty();
  });
  return result;
}

template Vector3d position<2>(const mesh::PartMesh<2>&, unsigned);
template Vector3d position<3>(const mesh::PartMesh<3>&, unsigned);
template std::vector<RoundSurface> round_surfaces<2>(const mesh::PartMesh<2>&);
template std::vector<RoundSurface> round_surfaces<3>(const mesh::PartMesh<3>&);

}  // namespace clevis::stress
