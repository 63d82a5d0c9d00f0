#include "assessment/places/local_solve.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <string>
#include <utility>

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

/// Cells that carry the load of those that are solved for.
template <int dim>
std::vector<int> needed_cells(const mesh::PartMesh<dim>& mesh,
                              const loads::LoadHistory& history,
                              const std::vector<int>& near) {
  std::vector<int> cells = mesh::with_neighbours(mesh, near);
  const auto loaded = loaded_cells(mesh, history);
  cells.insert(cells.end(), loaded.begin(), loaded.end());
  std::ranges::sort(cells);
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

template <int dim>
struct FinePart {
  std::vector<int> cells;  ///< of the mesh
  elasticity::Discretization<dim> discretization;
};

/// @param cells  of the mesh, ascending.
template <int dim>
FinePart<dim> discretized(const mesh::PartMesh<dim>& mesh,
                          std::vector<int> cells, int degree) {
  auto sub = mesh::sub_mesh(mesh, std::move(cells));
  return {std::move(sub.cells), elasticity::discretize<dim>(sub.mesh, degree)};
}

/// Corner points of a quadrangle or hexahedron [m].
template <int dim>
Eigen::Matrix<double, dim, Eigen::Dynamic> corner_points(
    const elasticity::Discretization<dim>& discretization, int cell) {
  const auto& points =
      discretization.cell_points[static_cast<std::size_t>(cell)];
  std::vector<int> corners;
  for (unsigned corner = 0; corner < (1U << dim); ++corner) {
    int at = 0;
    int stride = discretization.geometry_degree;
    for (int d = 0; d < dim; ++d) {
      at += ((corner >> d) & 1U) != 0 ? stride : 0;
      stride *= discretization.geometry_degree + 1;
    }
    corners.push_back(at);
  }
  return points(Eigen::all, corners);
}

/// Whether the cells run as they do among all: where not all cells can be
/// oriented alike, a few of them may be turned.
template <int dim>
bool runs_alike(const elasticity::Discretization<dim>& coarse,
                const FinePart<dim>& fine) {
  if (coarse.is_layer || coarse.is_revolved) return false;
  constexpr double kSame = 1e-6;
  for (std::size_t k = 0; k < fine.cells.size(); ++k) {
    const auto there = corner_points<dim>(coarse, fine.cells[k]);
    const auto here =
        corner_points<dim>(fine.discretization, static_cast<int>(k));
    const double size = (there.colwise() - there.col(0)).norm();
    if ((here - there).norm() > kSame * size) return false;
  }
  return true;
}

/// The near cells with those that they need; of hexahedra all, if need be.
template <int dim>
FinePart<dim> fine_part(const mesh::PartMesh<dim>& mesh,
                        const elasticity::Discretization<dim>& coarse,
                        const loads::LoadHistory& history,
                        const std::vector<int>& near, int degree) {
  auto fine = discretized<dim>(mesh, needed_cells(mesh, history, near), degree);
  if (mesh.shape == mesh::CellShape::kSimplex || runs_alike(coarse, fine)) {
    return fine;
  }
  std::vector<int> all(mesh.cells.size());
  std::iota(all.begin(), all.end(), 0);
  return discretized<dim>(mesh, std::move(all), degree);
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
  const auto [cells, fine] =
      fine_part(mesh, basis.discretization, one, near, place.degree);
  const MatrixXd load = elasticity::assemble_loads<dim>(
      fine, one, job.part.material.density, job.part.name);
  const MatrixXd u = basis.columns * basis.coefficients.col(place.instant);
  for (int& cell : near) {
    cell =
        static_cast<int>(std::ranges::lower_bound(cells, cell) - cells.begin());
  }
  return elasticity::enrich<dim>(
      {basis.discretization, u, fine, load,
       elasticity::held_on_groups<dim>(fine, set.fixed), job.part.material,
       cells, set.foundations},
      near);
}

template elasticity::Enriched<2> solve_nearby<2>(
    const PartJob&, const LoadSet&, const mesh::PartMesh<2>&,
    const elasticity::DisplacementBasis<2>&, const LocalPlace&);
template elasticity::Enriched<3> solve_nearby<3>(
    const PartJob&, const LoadSet&, const mesh::PartMesh<3>&,
    const elasticity::DisplacementBasis<3>&, const LocalPlace&);

}  // namespace clevis::assessment
