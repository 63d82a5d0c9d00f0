#include "assessment/models/rung.h"

#include <fmt/format.h>

#include "elasticity/assembly/stiffness.h"
#include "elasticity/plate/layered_solve.h"
#include "elasticity/solid/solid_solve.h"

namespace clevis::assessment {
namespace {

constexpr int kHighestDegree = 4;
constexpr int kHighestLayeredDegree = 5;

/// Raises a degree with which the interpolated geometry of a cell folds.
template <int dim>
int unfolded(const mesh::PartMesh<dim>& mesh, int degree, int highest) {
  while (degree < highest &&
         elasticity::folds<dim>(elasticity::discretize<dim>(mesh, degree))) {
    ++degree;
  }
  return degree;
}

}  // namespace

Rung<2> plane_stress_rung(const mesh::PartMesh<2>& plate) {
  Rung<2> rung;
  rung.name = "plane stress";
  rung.solve = elasticity::solve<2>;
  rung.highest_degree = kHighestDegree;
  rung.first_degree = unfolded(plate, 2, rung.highest_degree);
  rung.subdivisions = 8;
  // Degrees far above that of the geometry see the kinks between its arcs.
  constexpr int kSmoothGeometry = 4;
  rung.looks_nearby = plate.degree >= kSmoothGeometry;
  return rung;
}

Rung<3> layered_rung(const mesh::PartMesh<2>& plate, int terms,
                     int subdivisions) {
  Rung<3> rung;
  rung.name = fmt::format("2-D x thickness {0}+{0}", terms);
  rung.solve = [&plate, terms](const elasticity::ElasticProblem<3>& problem,
                               int degree) {
    return elasticity::solve_layered(
        {plate, problem.material, problem.history, problem.fixed, problem.name},
        degree, terms);
  };
  rung.highest_degree = kHighestLayeredDegree;
  // Degree 1 says nothing of how the peak comes to rest.
  rung.first_degree = unfolded(plate, 2, rung.highest_degree);
  rung.subdivisions = subdivisions;
  return rung;
}

Rung<3> solid_rung(const mesh::PartMesh<3>& mesh) {
  const bool is_tensor = mesh.shape == mesh::CellShape::kTensor;
  Rung<3> rung;
  rung.name = is_tensor ? "3-D" : "3-D tetrahedra";
  rung.solve = elasticity::solve<3>;
  rung.highest_degree = kHighestDegree;
  // In 3-D three degrees up to 3 are cheaper than 4 alone.
  rung.first_degree = unfolded(mesh, 1, rung.highest_degree);
  rung.subdivisions = 4;
  rung.looks_at_places = true;
  return rung;
}

}  // namespace clevis::assessment
