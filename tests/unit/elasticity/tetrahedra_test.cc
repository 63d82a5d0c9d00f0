// Patch test on triangles and tetrahedra of every degree: uniform stress is
// reproduced to round-off, also on curved cells.

#include <gtest/gtest.h>

#include "elasticity/fe_space/simplex_numbering.h"
#include "stress/field/stress_history.h"
#include "support/elastic_field_problem.h"
#include "support/field_error.h"
#include "support/simplex_mesh.h"

namespace clevis::elasticity {
namespace {

template <int dim>
using Vector = Eigen::Matrix<double, dim, 1>;

/// A block whose inner nodes are moved, and with curved cells its sides too.
template <int dim>
mesh::PartMesh<dim> block(int degree) {
  std::array<int, dim> divisions{};
  divisions.fill(2);
  auto mesh = support::simplex_mesh<dim>(
      divisions, degree, [&](const Vector<dim>& x) -> Vector<dim> {
        double inside = 1.0;
        for (int d = 0; d < dim; ++d) inside *= 4.0 * x[d] * (1.0 - x[d]);
        Vector<dim> y = x;
        for (int d = 0; d < dim; ++d) {
          y[d] += (0.1 - 0.06 * d) * inside;
          if (degree > 1) y[d] += 0.05 * x[(d + 1) % dim] * x[(d + 1) % dim];
        }
        return 0.03 * y;
      });
  if (dim == 2) mesh.thickness = 0.01;
  return mesh;
}

template <int dim>
void expect_uniform_stress(int geometry_degree) {
  const part::Material steel{"steel", 210e9, 0.3, 7850.0, 355e6};
  const auto mesh = block<dim>(geometry_degree);
  Eigen::Matrix3d stress;
  stress << 80e6, 20e6, -10e6, 20e6, -30e6, 15e6, -10e6, 15e6, 50e6;
  std::vector<support::TractionField<dim>> tractions;
  for (const auto& group : mesh.groups) {
    tractions.push_back(
        {group.name,
         [&](const Vector<dim>&, const Vector<dim>& n) -> Vector<dim> {
           return stress.topLeftCorner<dim, dim>() * n;
         }});
  }
  support::ExactField exact;
  exact.stress = [&](const Eigen::Vector3d&) {
    support::Vector6d s;
    s << 80e6, -30e6, 50e6, 20e6, 15e6, -10e6;
    if (dim == 2) s.tail<2>().setZero();
    if (dim == 2) s[2] = 0.0;
    return s;
  };
  const loads::LoadHistory none;
  for (int degree = 1; degree <= 4; ++degree) {
    const auto basis = support::solve_field<dim>(
        {mesh, steel, none, {}, "block"}, tractions, degree);
    EXPECT_LT(
        support::worst_stress_error(
            clevis::stress::instant_field<dim>(basis, steel, 4, 0), exact),
        1e-9 * 80e6)
        << "dim " << dim << ", degree " << degree;
  }
}

TEST(Simplices, PatchTest) {
  for (const int geometry_degree : {1, 2, 4}) {
    SCOPED_TRACE(geometry_degree);
    expect_uniform_stress<2>(geometry_degree);
    expect_uniform_stress<3>(geometry_degree);
  }
}

TEST(Simplices, NodesAreCountedOnce) {
  const auto mesh = block<3>(1);
  // Kuhn's tetrahedra of a grid of n³ cubes carry the lattice of (p n)³ cubes.
  for (int degree = 1; degree <= 4; ++degree) {
    const auto numbering = number_simplices<3>(mesh, degree);
    const int side = 2 * degree + 1;
    EXPECT_EQ(numbering.nodes, side * side * side);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
      EXPECT_GE(numbering.vertex_nodes[v], 0);
    }
  }
}

}  // namespace
}  // namespace clevis::elasticity
