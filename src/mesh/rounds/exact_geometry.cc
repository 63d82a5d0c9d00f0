#include "mesh/rounds/exact_geometry.h"

#include <algorithm>

#include "mesh/basis/simplex_basis.h"
#include "mesh/basis/tensor_basis.h"
#include "mesh/rounds/cylindrical_entities.h"
#include "mesh/rounds/hex_blend.h"
#include "mesh/rounds/simplex_blend.h"

namespace clevis::mesh {

namespace {

void elevate_hexahedra(PartMesh<3>& mesh, int degree) {
  const Eigen::MatrixXd up =
      lagrange(gauss_lobatto(mesh.degree), gauss_lobatto(degree)).value;
  for (auto& points : mesh.cell_points) {
    points = interpolate<3>(points, {&up, &up, &up});
  }
  mesh.degree = degree;
}

void elevate_tetrahedra(PartMesh<3>& mesh, int degree) {
  const Eigen::MatrixXd up =
      simplex_lagrange<3>(mesh.degree, simplex_nodes<3>(degree)).value;
  for (auto& points : mesh.cell_points) {
    points = (points * up.transpose()).eval();
  }
  mesh.degree = degree;
}

}  // namespace

void put_on_cylinders(PartMesh<3>& mesh) {
  const CylindricalEntities round = find_cylindrical_entities(mesh);
  if (round.faces.empty()) return;
  for (const auto& [v, groups] : round.vertices) {
    mesh.vertices[v] = project_on_all(mesh, groups, mesh.vertices[v]);
  }
  const int file_order = mesh.degree;
  if (mesh.shape == CellShape::kSimplex) {
    elevate_tetrahedra(mesh, std::max(file_order, kSimplexCylinderDegree));
    blend_tetrahedra(mesh, round, file_order);
    return;
  }
  elevate_hexahedra(mesh, std::max(file_order, kCylinderDegree));
  blend_hexahedra(mesh, round, file_order);
}

void put_on_cylinders(PartMesh<3>& mesh,
                      const std::vector<FacetedRound>& rounds) {
  // Groups for as long as it takes.
  const auto boundary = mesh.boundary;
  const std::size_t groups = mesh.groups.size();
  for (const FacetedRound& round : rounds) {
    for (const std::size_t face : round.faces) {
      mesh.boundary[face].group = int(mesh.groups.size());
    }
    mesh.groups.push_back({"", round.cylinder});
  }
  put_on_cylinders(mesh);
  mesh.boundary = boundary;
  mesh.groups.resize(groups);
}

}  // namespace clevis::mesh
