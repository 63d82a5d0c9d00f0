#include "mesh/rounds/cylindrical_entities.h"

#include <algorithm>

#include <Eigen/Dense>

#include "mesh/rounds/cylinder_fit.h"
#include "mesh/rounds/tangent_cylinder.h"

namespace clevis::mesh {

using Eigen::Vector3d;

Vector3d project_on_all(const PartMesh<3>& mesh, const std::set<int>& groups,
                        Vector3d p) {
  const int rounds = groups.size() > 1 ? 50 : 1;
  for (int round = 0; round < rounds; ++round) {
    for (const int g : groups) {
      p = project(*mesh.groups[std::size_t(g)].cylinder, p);
    }
  }
  return p;
}

CylindricalEntities find_cylindrical_entities(const PartMesh<3>& mesh) {
  CylindricalEntities round;
  for (const BoundaryFace& face : mesh.boundary) {
    if (face.group < 0 || !mesh.groups[std::size_t(face.group)].cylinder) {
      continue;
    }
    round.faces[{face.cell, face.face}] = face.group;
    const auto cycle = face_cycle(mesh, face);
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      round.vertices[cycle[i]].insert(face.group);
      round.edges[std::minmax(cycle[i], cycle[(i + 1) % cycle.size()])].insert(
          face.group);
    }
  }
  return round;
}

bool CylindricalEntities::touch(const std::vector<unsigned>& cell) const {
  return std::any_of(cell.begin(), cell.end(), [&](unsigned v) {
    return vertices.contains(v);
  });
}

std::vector<Vector3d> round_edge(const PartMesh<3>& mesh,
                                 const std::set<int>& groups, unsigned from,
                                 unsigned to, const std::vector<double>& t,
                                 const std::vector<Vector3d>& straight,
                                 int file_order) {
  // Points of a parabola over an arc of 90° slip by 0.02 along it.
  constexpr double kAcross = 0.01, kAlong = 0.05;
  const Vector3d &start = mesh.vertices[from], &end = mesh.vertices[to];
  const auto& cylinder = *mesh.groups[std::size_t(*groups.begin())].cylinder;
  std::vector<Vector3d> screw, own;
  const double length = (end - start).norm();
  bool is_even = true;
  for (std::size_t i = 0; i < t.size(); ++i) {
    own.push_back(project_on_all(mesh, groups, straight[i]));
    const Vector3d even = screw_line(cylinder, start, end, t[i]);
    screw.push_back(groups.size() > 1 ? project_on_all(mesh, groups, even)
                                      : even);
    const Vector3d apart = own.back() - screw.back();
    const double along = std::abs(apart.dot(end - start)) / length;
    is_even = is_even && along < kAlong * length &&
              std::sqrt(std::max(0.0, apart.squaredNorm() - along * along)) <
                  kAcross * length;
  }
  return file_order == 1 || is_even ? screw : own;
}

}  // namespace clevis::mesh
