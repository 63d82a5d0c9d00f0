#include "mesh/rounds/cylinder_groups.h"

#include <cmath>
#include <numbers>
#include <set>

#include <Eigen/Dense>
#include <fmt/format.h>

#include "base/messages/errors.h"
#include "mesh/basis/simplex_basis.h"
#include "mesh/basis/tensor_basis.h"
#include "mesh/cells/topology.h"
#include "mesh/rounds/cylinder_fit.h"
#include "mesh/rounds/tangent_cylinder.h"

namespace clevis::mesh {

namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

bool is_round(const std::string& name) {
  return name.starts_with("bore_") || name.starts_with("round_");
}

[[noreturn]] void refuse(const std::string& place, const std::string& problem) {
  throw Error("M009", place, problem,
              "Name the group without bore_ or round_ if it is not one "
              "circular cylinder, give each bore its own group, or mesh it "
              "with at least 5 facets around.");
}

void check_facet(const PartMesh<3>& mesh, const part::Bore& bore,
                 const std::vector<unsigned>& cycle, bool is_wall,
                 const std::string& place) {
  constexpr double kWidest = 89.9 * std::numbers::pi / 180.0;
  Vector3d middle = Vector3d::Zero();
  for (const unsigned a : cycle) {
    middle += mesh.vertices[a] / double(cycle.size());
    for (const unsigned b : cycle) {
      const double angle =
          std::abs(angle_between(bore, mesh.vertices[a], mesh.vertices[b]));
      if (angle > kWidest) {
        refuse(place, fmt::format("one of its facets spans {:.0f}°",
                                  angle * 180.0 / std::numbers::pi));
      }
    }
  }
  if (is_wall) return;  // however steep where the bore ends on a round
  const Vector3d outward = (project(bore, middle) - middle).normalized();
  const Vector3d normal = area_vector(mesh, cycle).normalized();
  // A lid whose corners happen to lie on the cylinder is no part of its wall.
  if (std::abs(normal.dot(bore.axis_L)) > 0.7 || !outward.allFinite()) {
    refuse(place, "one of its faces is across the axis");
  }
}

/// Points of a group and normals of the facets between them.
struct Facets {
  std::vector<std::vector<unsigned>> cycles;
  Matrix3Xd points, normals;
};

Facets facets_of(const PartMesh<3>& mesh, int group) {
  Facets facets;
  std::set<unsigned> corners;
  for (const BoundaryFace& face : mesh.boundary) {
    if (face.group != group) continue;
    facets.cycles.push_back(face_cycle(mesh, face));
    corners.insert(facets.cycles.back().begin(), facets.cycles.back().end());
  }
  facets.points.resize(3, Index(corners.size()));
  Index i = 0;
  for (const unsigned v : corners) facets.points.col(i++) = mesh.vertices[v];
  facets.normals.resize(3, Index(facets.cycles.size()));
  for (std::size_t f = 0; f < facets.cycles.size(); ++f) {
    facets.normals.col(Index(f)) = area_vector(mesh, facets.cycles[f]);
  }
  return facets;
}

/// The same with the nodes of the curved faces of a file of order 2 or more,
/// and the facets between these.
Facets curved_quadrangles_of(const PartMesh<3>& mesh, int group) {
  const int k = mesh.degree, n = k + 1;
  const auto nodes = gauss_lobatto(k);
  const LagrangeBasis even =
      lagrange(nodes, Eigen::VectorXd::LinSpaced(n, 0.0, 1.0));
  Facets facets = facets_of(mesh, group);
  const auto faces = Index(facets.cycles.size());
  facets.points.resize(3, faces * n * n);
  facets.normals.resize(3, faces * k * k);
  Index point = 0, normal = 0;
  for (const BoundaryFace& face : mesh.boundary) {
    if (face.group != group) continue;
    const LagrangeBasis end =
        lagrange(nodes, Eigen::VectorXd::Constant(1, face.face % 2));
    std::array<const LagrangeBasis*, 3> along = {&even, &even, &even};
    along[std::size_t(face.face / 2)] = &end;
    const Matrix3Xd grid =
        map_grid<3>(mesh.cell_points[std::size_t(face.cell)], along).points;
    facets.points.middleCols(point, n * n) = grid;
    point += n * n;
    for (int j = 0; j < k; ++j) {
      for (int i = 0; i < k; ++i) {
        const Vector3d p = grid.col(i + n * j), q = grid.col(i + 1 + n * j);
        const Vector3d r = grid.col(i + n * (j + 1));
        const Vector3d s = grid.col(i + 1 + n * (j + 1));
        facets.normals.col(normal++) = 0.5 * (s - p).cross(r - q);
      }
    }
  }
  return facets;
}

Facets curved_triangles_of(const PartMesh<3>& mesh, int group) {
  Facets facets = facets_of(mesh, group);
  const auto parts = simplex_parts<2>(mesh.degree);
  const auto faces = Index(facets.cycles.size());
  const auto nodes = Index(simplex_lattice<2>(mesh.degree).size());
  facets.points.resize(3, faces * nodes);
  facets.normals.resize(3, faces * Index(parts.size()));
  Index point = 0, normal = 0;
  for (const BoundaryFace& face : mesh.boundary) {
    if (face.group != group) continue;
    const Matrix3Xd& cell = mesh.cell_points[std::size_t(face.cell)];
    for (const int node : simplex_face_lattice<3>(mesh.degree, face.face)) {
      facets.points.col(point++) = cell.col(node);
    }
    const auto here = facets.points.middleCols(point - nodes, nodes);
    for (const auto& part : parts) {
      const Vector3d p = here.col(part[0]), q = here.col(part[1]);
      const Vector3d r = here.col(part[2]);
      facets.normals.col(normal++) = 0.5 * (q - p).cross(r - p);
    }
  }
  return facets;
}

/// @pre the file is of order 2 or more.
Facets curved_facets_of(const PartMesh<3>& mesh, int group) {
  return mesh.shape == CellShape::kTensor ? curved_quadrangles_of(mesh, group)
                                          : curved_triangles_of(mesh, group);
}

/// Whether the nodes of each curved face lie on the cylinder: those of a lid
/// lie on its chords.
std::vector<bool> are_wall(const PartMesh<3>& mesh, int group,
                           const Facets& facets, const part::Bore& bore) {
  constexpr double kOff = 1e-3;  // of the radius
  std::vector<bool> all(facets.cycles.size(), false);
  if (mesh.degree == 1 || all.empty()) return all;
  const Facets curved = curved_facets_of(mesh, group);
  const Index nodes = curved.points.cols() / std::ssize(all);
  for (std::size_t f = 0; f < all.size(); ++f) {
    all[f] = worst_distance(curved.points.middleCols(Index(f) * nodes, nodes),
                            bore) <= kOff * bore.radius;
  }
  return all;
}

/// The cylinder of a group whose corners alone do not determine it.
part::Bore fit_one_facet_wide(const PartMesh<3>& mesh, int group,
                              const std::string& place) {
  if (mesh.degree > 1) {
    const Facets curved = curved_facets_of(mesh, group);
    if (determine_axis(curved.normals)) {
      return fit_cylinder(curved.points, curved.normals, place).bore;
    }
  }
  return fit_tangent_cylinder(mesh, group, place);
}

void check_group(const PartMesh<3>& mesh, int group, const Facets& facets,
                 const part::Bore& bore, const std::string& place) {
  const double worst = worst_distance(facets.points, bore);
  if (!(worst <= 1e-5 * bore.radius)) {
    refuse(place,
           fmt::format("a node is {:.4g} mm off the nearest cylinder, which "
                       "has a radius of {:.6g} mm",
                       1e3 * worst, 1e3 * bore.radius));
  }
  const auto wall = are_wall(mesh, group, facets, bore);
  for (std::size_t f = 0; f < facets.cycles.size(); ++f) {
    check_facet(mesh, bore, facets.cycles[f], wall[f], place);
  }
}

}  // namespace

void fit_cylinder_groups(PartMesh<3>& mesh, const std::string& file) {
  // Those that need their neighbours come last.
  for (const bool alone : {true, false}) {
    for (std::size_t g = 0; g < mesh.groups.size(); ++g) {
      SurfaceGroup& group = mesh.groups[g];
      if (!is_round(group.name) || group.cylinder) continue;
      const Facets facets = facets_of(mesh, int(g));
      if (determine_axis(facets.normals) != alone) continue;
      const std::string place = fmt::format("{}, {}", file, group.name);
      part::Bore bore =
          alone ? fit_cylinder(facets.points, facets.normals, place).bore
                : fit_one_facet_wide(mesh, int(g), place);
      set_extent(facets.points, bore);
      check_group(mesh, int(g), facets, bore, place);
      group.cylinder = bore;
    }
  }
}

}  // namespace clevis::mesh
