#include "mesh/rounds/tangent_cylinder.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Geometry>

#include "base/messages/errors.h"
#include "mesh/cells/topology.h"

namespace clevis::mesh {

namespace {

using Eigen::Vector3d;

/// An edge of the facet and the normal of the surface beyond it.
struct SmoothEdge {
  Vector3d from, to;
  Vector3d normal;  ///< on the side that the facet's normal points to
};

[[noreturn]] void refuse(const std::string& place) {
  throw Error("M009", place,
              "it is one flat facet wide and no arc is tangent to the "
              "surfaces on both sides of it",
              "Mesh the round with at least two facets, or name the group "
              "without round_ or bore_.");
}

/// Normal of the surface of `face` at p.
Vector3d surface_normal(const PartMesh<3>& mesh, const BoundaryFace& face,
                        const Vector3d& p) {
  if (face.group >= 0) {
    const auto& cylinder = mesh.groups[std::size_t(face.group)].cylinder;
    if (cylinder) {
      const Vector3d r = p - cylinder->p_LC;
      return (r - r.dot(cylinder->axis_L) * cylinder->axis_L).normalized();
    }
  }
  return area_vector(mesh, face_cycle(mesh, face)).normalized();
}

/// The face beyond an edge of the group, if it is no lid across the edge.
std::optional<SmoothEdge> smooth_edge(const PartMesh<3>& mesh, int group,
                                      const Vector3d& facet_normal, unsigned a,
                                      unsigned b) {
  for (const BoundaryFace& face : mesh.boundary) {
    if (face.group == group) continue;
    const auto cycle = face_cycle(mesh, face);
    if (std::find(cycle.begin(), cycle.end(), a) == cycle.end() ||
        std::find(cycle.begin(), cycle.end(), b) == cycle.end()) {
      continue;
    }
    const Vector3d &from = mesh.vertices[a], &to = mesh.vertices[b];
    Vector3d normal = surface_normal(mesh, face, 0.5 * (from + to));
    if (normal.dot(facet_normal) < 0.0) normal = -normal;
    if (normal.dot(facet_normal) < 0.5) continue;
    return SmoothEdge{from, to, normal};
  }
  return std::nullopt;
}

/// Whether both edges lie on one line.
bool collinear(const SmoothEdge& a, const SmoothEdge& b) {
  const Vector3d along = (a.to - a.from).normalized();
  const Vector3d between = 0.5 * (b.from + b.to - a.from - a.to);
  return along.cross(between).norm() <= 1e-6 * (a.to - a.from).norm();
}

/// The edges that others continue smoothly, one a line; the facets, a
/// quadrangle or triangles, lie in one plane.
std::vector<SmoothEdge> smooth_edges(const PartMesh<3>& mesh, int group,
                                     Vector3d& facet_normal) {
  std::vector<SmoothEdge> edges;
  bool first = true;
  for (const BoundaryFace& face : mesh.boundary) {
    if (face.group != group) continue;
    const auto cycle = face_cycle(mesh, face);
    if (first) facet_normal = area_vector(mesh, cycle).normalized();
    first = false;
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      const auto edge = smooth_edge(mesh, group, facet_normal, cycle[i],
                                    cycle[(i + 1) % cycle.size()]);
      const bool is_new =
          edge && std::none_of(edges.begin(), edges.end(), [&](const auto& e) {
            return collinear(e, *edge);
          });
      if (is_new) edges.push_back(*edge);
    }
  }
  return edges;
}

}  // namespace

std::vector<unsigned> face_cycle(const PartMesh<3>& mesh,
                                 const BoundaryFace& face) {
  const FaceVertices v = face_vertices(mesh, face.cell, face.face);
  if (v[3] == kNoVertex) return {v[0], v[1], v[2]};
  return {v[0], v[1], v[3], v[2]};
}

Vector3d area_vector(const PartMesh<3>& mesh,
                     const std::vector<unsigned>& cycle) {
  const Vector3d& origin = mesh.vertices[cycle[0]];
  Vector3d sum = Vector3d::Zero();
  for (std::size_t i = 2; i < cycle.size(); ++i) {
    sum += 0.5 * (mesh.vertices[cycle[i - 1]] - origin)
                     .cross(mesh.vertices[cycle[i]] - origin);
  }
  return sum;
}

part::Bore fit_tangent_cylinder(const PartMesh<3>& mesh, int group,
                                const std::string& place) {
  Vector3d n = Vector3d::Zero();
  const auto edges = smooth_edges(mesh, group, n);
  if (edges.size() != 2) refuse(place);
  const SmoothEdge &first = edges[0], &second = edges[1];
  part::Bore bore;
  bore.axis_L = (first.to - first.from).normalized();
  Eigen::Index main_axis = 0;
  bore.axis_L.cwiseAbs().maxCoeff(&main_axis);
  if (bore.axis_L[main_axis] < 0.0) bore.axis_L = -bore.axis_L;
  if (bore.axis_L.cross((second.to - second.from).normalized()).norm() > 1e-6) {
    refuse(place);
  }
  const Vector3d p = 0.5 * (first.from + first.to);
  Vector3d chord = 0.5 * (second.from + second.to) - p;
  chord -= chord.dot(bore.axis_L) * bore.axis_L;
  const double half = 0.5 * chord.norm();
  const Vector3d c = chord.normalized();
  // The centre is `height` from the chord's middle along n, where both
  // normals, and so both radii, meet; behind the facet if it bulges.
  const double height = half * first.normal.dot(n) / first.normal.dot(c);
  const double other = -half * second.normal.dot(n) / second.normal.dot(c);
  bore.radius = std::hypot(half, height);
  if (!(std::abs(height - other) <= 1e-5 * bore.radius)) refuse(place);
  bore.p_LC = p + half * c + height * n;
  return bore;
}

}  // namespace clevis::mesh
