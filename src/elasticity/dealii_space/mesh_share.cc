#include "elasticity/dealii_space/mesh_share.h"

#include <cmath>
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

/// Cells on their way between ranks, one behind the other.
struct PackedCells {
  std::vector<double> points;  ///< geometry points, lexicographic [m]
  std::vector<int> nodes;
  std::vector<char> is_held;
};

template <int dim>
PackedCells pack(const DealiiTask<dim>& task, const std::vector<char>& is_held,
                 const std::vector<unsigned>& cells) {
  PackedCells packed;
  for (const unsigned c : cells) {
    const auto& points = task.discretization.cell_points[c];
    packed.points.insert(packed.points.end(), points.data(),
                         points.data() + points.size());
    for (const int node : task.discretization.cell_nodes[c]) {
      packed.nodes.push_back(node);
      for (int a = 0; a < dim; ++a) {
        packed.is_held.push_back(
            is_held[static_cast<std::size_t>(dim * node + a)]);
      }
    }
  }
  return packed;
}

template <class T>
void send(const std::vector<T>& values, int rank, MPI_Comm ranks) {
  MPI_Send(values.data(), static_cast<int>(values.size()),
           dealii::Utilities::MPI::mpi_type_id_for_type<T>, rank, 0, ranks);
}

/// @param rank  that sends as many as `values` has.
template <class T>
void receive(std::vector<T>& values, int rank, MPI_Comm ranks) {
  MPI_Recv(values.data(), static_cast<int>(values.size()),
           dealii::Utilities::MPI::mpi_type_id_for_type<T>, rank, 0, ranks,
           MPI_STATUS_IGNORE);
}

/// From the first rank, to each the cells that it wants.
template <int dim>
PackedCells deal_cells(const DealiiTask<dim>* task, const EnginePart& part,
                       const std::vector<unsigned>& wanted, MPI_Comm ranks) {
  const auto all = dealii::Utilities::MPI::gather(ranks, wanted);
  if (task == nullptr) {
    const auto power = [&](int degree) {
      return wanted.size() *
             static_cast<std::size_t>(std::lround(std::pow(degree + 1.0, dim)));
    };
    PackedCells packed;
    packed.points.resize(dim * power(part.geometry_degree));
    packed.nodes.resize(power(part.degree));
    packed.is_held.resize(dim * packed.nodes.size());
    receive(packed.points, 0, ranks);
    receive(packed.nodes, 0, ranks);
    receive(packed.is_held, 0, ranks);
    return packed;
  }
  const std::vector<char> is_held = held_marks(*task);
  for (std::size_t r = 1; r < all.size(); ++r) {
    const PackedCells packed = pack(*task, is_held, all[r]);
    send(packed.points, static_cast<int>(r), ranks);
    send(packed.nodes, static_cast<int>(r), ranks);
    send(packed.is_held, static_cast<int>(r), ranks);
  }
  return pack(*task, is_held, wanted);
}

}  // namespace

template <int dim>
MeshShare<dim>::MeshShare(const DealiiTask<dim>* task, const EnginePart& part,
                          MPI_Comm ranks)
    : ranks_(ranks),
      degree_(part.degree),
      triangulation_(ranks),
      mapping_(static_cast<unsigned>(part.geometry_degree)) {
  const auto count = dealii::Utilities::MPI::n_mpi_processes(ranks);
  triangulation_.create_triangulation(
      dealii::TriangulationDescription::Utilities::
          create_description_from_triangulation_in_groups<dim, dim>(
              [&](dealii::Triangulation<dim>& mesh) {  // on the first rank
                create_coarse_mesh(task->discretization, mesh);
              },
              [](dealii::Triangulation<dim>& mesh, MPI_Comm among, unsigned) {
                deal_out(dealii::Utilities::MPI::n_mpi_processes(among), mesh);
              },
              ranks, static_cast<int>(count)));
  take_cells(task, part);
}

template <int dim>
void MeshShare<dim>::take_cells(const DealiiTask<dim>* task,
                                const EnginePart& part) {
  std::vector<unsigned> wanted;
  for (const auto& cell : triangulation_.active_cell_iterators()) {
    if (!cell->is_artificial()) {
      wanted.push_back(static_cast<unsigned>(number(cell)));
    }
  }
  const PackedCells packed = deal_cells(task, part, wanted, ranks_);
  std::unordered_map<std::size_t, std::size_t> place;
  const std::size_t nodes =
      wanted.empty() ? 0 : packed.nodes.size() / wanted.size();
  for (std::size_t w = 0; w < wanted.size(); ++w) {
    place.emplace(wanted[w], w);
    const auto from = static_cast<std::ptrdiff_t>(w * nodes);
    const auto to = static_cast<std::ptrdiff_t>((w + 1) * nodes);
    cells_[wanted[w]] = {
        {packed.nodes.begin() + from, packed.nodes.begin() + to},
        {packed.is_held.begin() + dim * from,
         packed.is_held.begin() + dim * to}};
  }
  const auto lexicographic =
      dealii::FETools::hierarchic_to_lexicographic_numbering<dim>(
          static_cast<unsigned>(part.geometry_degree));
  mapping_.initialize(
      triangulation_,
      [&](const typename dealii::Triangulation<dim>::cell_iterator& cell) {
        std::vector<dealii::Point<dim>> points(lexicographic.size());
        // One that stands in for the cells of no rank stays at the origin.
        if (cell->is_artificial()) return points;
        const std::size_t first =
            place.at(number(cell)) * dim * lexicographic.size();
        for (std::size_t i = 0; i < points.size(); ++i) {
          for (unsigned d = 0; d < dim; ++d) {
            points[i][d] = packed.points[first + dim * lexicographic[i] + d];
          }
        }
        return points;
      });
}

template class MeshShare<2>;
template class MeshShare<3>;

}  // namespace clevis::elasticity
