#include "assessment/places/local_solve.h"

#include <algorithm>
#include <set>
#include <string>

#include "elasticity/assembly/supports.h"
#include "elasticity/nodal_loads/load_vectors.h"
#include "mesh/derived/sub_mesh.h"

namespace clevis::assessment {
namespace {

using Eigen::MatrixXd;

/// Cells with a face in a group that an instant loads: tractions are scaled
/// over whole groups.
template <int dim>
std::vector<int> loaded_cells(const mesh::PartMesh<dim>& mesh,
                              const loads::LoadHistory& history) {
  std::set<std::string> groups;
  for (const auto& seat : history.seats) {
    groups.insert(seat.group);
    if (seat.slide) groups.insert(seat.slide->opposite);
  }
  for (const auto& load : history.instants.front().surface_loads) {
    groups.insert(load.group);
  }
  std::vector<int> cells;
  for (const auto& face : mesh.boundary) {
    if (face.group >= 0 &&
        groups.contains(
            mesh.groups[static_cast<std::size_t>(face.group)].name)) {
      cells.push_back(face.cell);
    }
  }
  return cells;
}

/// All cells of a tensor mesh, which deal.II orients together.
template <int dim>
std::vector<int> needed_cells(const mesh::PartMesh<dim>& mesh,
                              const loads::LoadHistory& history,
                              const std::vector<int>& near) {
  std::vector<int> cells;
  if (mesh.shape == mesh::CellShape::kTensor) {
    cells.resize(mesh.cells.size());
    for (std::size_t c = 0; c < cells.size(); ++c) {
      cells[c] = static_cast<int>(c);
    }
    return cells;
  }
  cells = mesh::with_neighbours(mesh, near);
  const auto loaded = loaded_cells(mesh, history);
  cells.insert(cells.end(), loaded.begin(), loaded.end());
  std::ranges::sort(cells);
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

}  // namespace

template <int dim>
elasticity::Enriched<dim> solve_nearby(
    const PartJob& job, const LoadSet& set, const mesh::PartMesh<dim>& mesh,
    const elasticity::DisplacementBasis<dim>& basis, const LocalPlace& place) {
  const loads::LoadHistory one{
      set.history.seats,
      {set.history.instants[static_cast<std::size_t>(place.instant)]}};
  auto near = mesh::surroundings(mesh, place.centre, place.layers);
  const auto sub = mesh::sub_mesh(mesh, needed_cells(mesh, one, near));
  const auto fine = elasticity::discretize<dim>(sub.mesh, place.degree);
  const MatrixXd load = elasticity::assemble_loads<dim>(
      fine, one, job.part.material.density, job.part.name);
  const MatrixXd u = basis.columns * basis.coefficients.col(place.instant);
  for (int& cell : near) {
    cell = static_cast<int>(std::ranges::lower_bound(sub.cells, cell) -
                            sub.cells.begin());
  }
  return elasticity::enrich<dim>(
      {basis.discretization, u, fine, load,
       elasticity::held_on_groups<dim>(fine, set.fixed), job.part.material,
       sub.cells, set.foundations},
      near);
}

template elasticity::Enriched<2> solve_nearby<2>(
    const PartJob&, const LoadSet&, const mesh::PartMesh<2>&,
    const elasticity::DisplacementBasis<2>&, const LocalPlace&);
template elasticity::Enriched<3> solve_nearby<3>(
    const PartJob&, const LoadSet&, const mesh::PartMesh<3>&,
    const elasticity::DisplacementBasis<3>&, const LocalPlace&);

}  // namespace clevis::assessment
