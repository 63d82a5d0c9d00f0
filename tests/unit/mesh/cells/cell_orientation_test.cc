#include "mesh/cells/cell_orientation.h"

#include <algorithm>
#include <set>
#include <utility>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "support/structured_mesh.h"
#include "support/turned_cells.h"

namespace clevis::mesh {
namespace {

using Cells = std::vector<std::vector<unsigned>>;

template <int dim>
PartMesh<dim> grid(std::array<int, dim> divisions) {
  using Point = Eigen::Matrix<double, dim, 1>;
  return support::structured_mesh<dim>(divisions, 1, [](const Point& x) {
    return x;
  });
}

/// Whether no two cells run along an edge against each other.
template <int dim>
bool agree(const Cells& cells) {
  std::set<std::pair<unsigned, unsigned>> edges;
  for (const auto& cell : cells) {
    for (unsigned corner = 0; corner < cell.size(); ++corner) {
      for (unsigned d = 0; d < dim; ++d) {
        if (((corner >> d) & 1U) != 0) continue;
        edges.insert({cell[corner], cell[corner | (1U << d)]});
      }
    }
  }
  return std::ranges::none_of(edges, [&](const auto& edge) {
    return edges.contains({edge.second, edge.first});
  });
}

template <int dim>
double determinant(const PartMesh<dim>& mesh,
                   const std::vector<unsigned>& cell) {
  Eigen::Matrix<double, dim, dim> edges;
  for (int d = 0; d < dim; ++d) {
    edges.col(d) = mesh.vertices[cell[1U << d]] - mesh.vertices[cell[0]];
  }
  return edges.determinant();
}

template <int dim>
void expect_agreement(const PartMesh<dim>& mesh) {
  Cells cells = mesh.cells;
  EXPECT_FALSE(agree<dim>(cells));
  orient_cells<dim>(cells);
  EXPECT_TRUE(agree<dim>(cells));
  for (std::size_t c = 0; c < cells.size(); ++c) {
    EXPECT_GT(determinant<dim>(mesh, cells[c]), 0.0) << "cell " << c;
    EXPECT_TRUE(std::ranges::is_permutation(cells[c], mesh.cells[c]));
  }
}

TEST(CellOrientation, CellsTurnedAtRandomAgreeAndStayRightHanded) {
  expect_agreement<2>(support::with_turned_cells(grid<2>({5, 4})));
  expect_agreement<3>(support::with_turned_cells(grid<3>({3, 4, 2})));
}

TEST(CellOrientation, CellsThatAgreeStay) {
  const auto mesh = grid<3>({2, 3, 2});
  Cells cells = mesh.cells;
  orient_cells<3>(cells);
  EXPECT_EQ(cells, mesh.cells);
}

TEST(CellOrientation, CellsThatCannotAgreeStay) {
  const auto mesh = support::moebius_ring(9);
  EXPECT_FALSE(agree<3>(mesh.cells));
  Cells cells = mesh.cells;
  orient_cells<3>(cells);
  EXPECT_EQ(cells, mesh.cells);
}

}  // namespace
}  // namespace clevis::mesh
