// deal.II is the oracle of the nodes' numbers, positions that of shared nodes.
#include "elasticity/fe_space/tensor_numbering.h"

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>
#include <gtest/gtest.h>

#include "elasticity/fe_space/discretization.h"
#include "mesh/basis/cell_parts.h"
#include "support/structured_mesh.h"
#include "support/turned_cells.h"

namespace clevis::elasticity {
namespace {

using Numbers = std::vector<std::vector<int>>;

template <int dim>
Numbers numbers_of_dealii(const mesh::PartMesh<dim>& mesh, int degree) {
  std::vector<dealii::Point<dim>> vertices;
  for (const auto& vertex : mesh.vertices) {
    dealii::Point<dim> point;
    for (int d = 0; d < dim; ++d) point[static_cast<unsigned>(d)] = vertex[d];
    vertices.push_back(point);
  }
  std::vector<dealii::CellData<dim>> cells;
  for (const auto& ids : mesh.cells) {
    dealii::CellData<dim> cell(static_cast<unsigned>(ids.size()));
    cell.vertices = ids;
    cells.push_back(cell);
  }
  dealii::GridTools::consistently_order_cells(cells);
  dealii::Triangulation<dim> triangulation;
  triangulation.create_triangulation(vertices, cells, dealii::SubCellData());
  dealii::DoFHandler<dim> handler(triangulation);
  handler.distribute_dofs(dealii::FE_Q<dim>(static_cast<unsigned>(degree)));
  Numbers numbers;
  for (const auto& cell : handler.active_cell_iterators()) {
    std::vector<dealii::types::global_dof_index> dofs(
        cell->get_fe().n_dofs_per_cell());
    cell->get_dof_indices(dofs);
    numbers.emplace_back(dofs.begin(), dofs.end());
  }
  return numbers;
}

template <int dim>
mesh::PartMesh<dim> turned_grid(std::array<int, dim> divisions) {
  using Point = Eigen::Matrix<double, dim, 1>;
  return support::with_turned_cells(
      support::structured_mesh<dim>(divisions, 1, [](const Point& x) {
        return x;
      }));
}

/// Largest distance between what two cells say of a node's position [m].
template <int dim>
double distance_of_shared_nodes(const Discretization<dim>& discretization) {
  const auto points = displacement_support_points<dim>(
      discretization.shape, discretization.displacement_degree());
  const auto geometry = tabulate_geometry<dim>(
      discretization.shape, discretization.mapping_degree(), points);
  std::vector<Eigen::Matrix<double, dim, 1>> position(
      static_cast<std::size_t>(discretization.nodes));
  std::vector<bool> is_known(position.size(), false);
  double farthest = 0.0;
  for (std::size_t c = 0; c < discretization.cell_nodes.size(); ++c) {
    const Eigen::MatrixXd at =
        discretization.cell_points[c] * geometry.values.transpose();
    for (std::size_t i = 0; i < discretization.cell_nodes[c].size(); ++i) {
      const auto node =
          static_cast<std::size_t>(discretization.cell_nodes[c][i]);
      const Eigen::Matrix<double, dim, 1> here =
          at.col(static_cast<Eigen::Index>(i));
      if (is_known[node]) {
        farthest = std::max(farthest, (position[node] - here).norm());
      }
      position[node] = here;
      is_known[node] = true;
    }
  }
  return farthest;
}

TEST(TensorNumbering, IsThatOfDealii) {
  const auto flat = turned_grid<2>({5, 4});
  const auto solid = turned_grid<3>({3, 4, 2});
  for (int degree = 1; degree <= 4; ++degree) {
    EXPECT_EQ(discretize<2>(flat, degree).cell_nodes,
              numbers_of_dealii<2>(flat, degree));
    EXPECT_EQ(discretize<3>(solid, degree).cell_nodes,
              numbers_of_dealii<3>(solid, degree));
  }
}

TEST(TensorNumbering, FunctionsAreInTheOrderOfDealii) {
  for (unsigned p = 1; p <= 5; ++p) {
    const int degree = static_cast<int>(p);
    EXPECT_EQ(mesh::lexicographic_numbers<2>(degree),
              dealii::FETools::hierarchic_to_lexicographic_numbering<2>(p));
    EXPECT_EQ(mesh::lexicographic_numbers<3>(degree),
              dealii::FETools::hierarchic_to_lexicographic_numbering<3>(p));
  }
}

TEST(TensorNumbering, NodesThatCellsShareStandAtOnePlace) {
  for (int degree = 1; degree <= 4; ++degree) {
    EXPECT_LT(distance_of_shared_nodes<3>(
                  discretize<3>(turned_grid<3>({3, 2, 2}), degree)),
              1e-12);
  }
}

// Its cells cannot agree: edges and a face are met against their direction.
TEST(TensorNumbering, ARingTurnedByHalfATurnIsClosed) {
  constexpr int kCells = 9;
  const auto ring = support::moebius_ring(kCells);
  for (int degree = 1; degree <= 4; ++degree) {
    const auto discretization = discretize<3>(ring, degree);
    const int inner = degree - 1;
    EXPECT_EQ(
        discretization.nodes,
        kCells * (4 + 8 * inner + 5 * inner * inner + inner * inner * inner));
    EXPECT_LT(distance_of_shared_nodes<3>(discretization), 1e-12);
  }
}

}  // namespace
}  // namespace clevis::elasticity
