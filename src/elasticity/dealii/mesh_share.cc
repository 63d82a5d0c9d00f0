#include "elasticity/dealii/mesh_share.h"

#include <vector>

#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria_description.h>

namespace clevis::elasticity {
namespace {

/// Lexicographic number of a corner among the geometry points of a cell.
int corner_point(unsigned corner, int degree, int dim) {
  int number = 0;
  int stride = degree;
  for (int d = 0; d < dim; ++d) {
    if (((corner >> d) & 1U) != 0) number += stride;
    stride *= degree + 1;
  }
  return number;
}

template <int dim>
dealii::Point<dim> point(const Eigen::Matrix<double, dim, 1>& from) {
  dealii::Point<dim> to;
  for (int d = 0; d < dim; ++d) to[static_cast<unsigned>(d)] = from[d];
  return to;
}

/// The first functions of a cell are those of its corners, ordered as deal.II
/// orders them, so that its edges and faces come out as in discretize().
template <int dim>
void create_coarse_mesh(const Discretization<dim>& discretization,
                        dealii::Triangulation<dim>& mesh) {
  constexpr unsigned kCorners = 1U << dim;
  std::vector<unsigned> vertex(static_cast<std::size_t>(discretization.nodes),
                               dealii::numbers::invalid_unsigned_int);
  std::vector<dealii::Point<dim>> vertices;
  std::vector<dealii::CellData<dim>> cells;
  for (std::size_t c = 0; c < discretization.cell_nodes.size(); ++c) {
    dealii::CellData<dim> cell(kCorners);
    for (unsigned k = 0; k < kCorners; ++k) {
      const auto node =
          static_cast<std::size_t>(discretization.cell_nodes[c][k]);
      if (vertex[node] == dealii::numbers::invalid_unsigned_int) {
        vertex[node] = static_cast<unsigned>(vertices.size());
        vertices.push_back(point<dim>(discretization.cell_points[c].col(
            corner_point(k, discretization.geometry_degree, dim))));
      }
      cell.vertices[k] = vertex[node];
    }
    cells.push_back(cell);
  }
  mesh.create_triangulation(vertices, cells, dealii::SubCellData());
}

/// By METIS; in the order of the cells where each rank has a few only.
template <int dim>
void deal_out(unsigned ranks, dealii::Triangulation<dim>& mesh) {
  constexpr unsigned kFew = 8;
  if (mesh.n_active_cells() < kFew * ranks) {
    dealii::GridTools::partition_triangulation_zorder(ranks, mesh);
  } else {
    dealii::GridTools::partition_triangulation(ranks, mesh);
  }
}

}  // namespace

template <int dim>
MeshShare<dim>::MeshShare(const Discretization<dim>& discretization,
                          MPI_Comm ranks)
    : ranks_(ranks),
      triangulation_(ranks),
      mapping_(static_cast<unsigned>(discretization.geometry_degree)) {
  const auto count = dealii::Utilities::MPI::n_mpi_processes(ranks);
  triangulation_.create_triangulation(
      dealii::TriangulationDescription::Utilities::
          create_description_from_triangulation_in_groups<dim, dim>(
              [&](dealii::Triangulation<dim>& mesh) {
                create_coarse_mesh(discretization, mesh);
              },
              [](dealii::Triangulation<dim>& mesh, MPI_Comm among, unsigned) {
                deal_out(dealii::Utilities::MPI::n_mpi_processes(among), mesh);
              },
              ranks, static_cast<int>(count)));
  const auto lexicographic =
      dealii::FETools::hierarchic_to_lexicographic_numbering<dim>(
          static_cast<unsigned>(discretization.geometry_degree));
  mapping_.initialize(
      triangulation_,
      [&](const typename dealii::Triangulation<dim>::cell_iterator& cell) {
        std::vector<dealii::Point<dim>> points;
        if (cell->is_artificial()) {  // stands in for the cells of no rank
          points.resize(lexicographic.size());
          return points;
        }
        const auto& from = discretization.cell_points[number(cell)];
        for (const unsigned i : lexicographic) {
          points.push_back(point<dim>(from.col(static_cast<int>(i))));
        }
        return points;
      });
}

template class MeshShare<2>;
template class MeshShare<3>;

}  // namespace clevis::elasticity
