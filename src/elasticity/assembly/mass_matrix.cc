#include "elasticity/assembly/mass_matrix.h"

#include <algorithm>
#include <utility>

#include "elasticity/algebra/dense_product.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// The rule of node_volumes: the rows' sums are its volumes times the density.
template <int dim>
Quadrature<dim> mass_quadrature(const Discretization<dim>& discretization) {
  const int more = discretization.shape == mesh::CellShape::kTensor
                       ? 2
                       : 1 + discretization.geometry_degree;
  return gauss<dim>(
      discretization.shape,
      {discretization.degree + more, discretization.thickness_degree + more});
}

}  // namespace

void add_element(const std::vector<int>& ids, const MatrixXd& element,
                 MassMatrix& mass) {
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const auto row = static_cast<std::size_t>(ids[i]);
    const auto begin = mass.column.begin() + mass.row_start[row];
    const auto end = mass.column.begin() + mass.row_start[row + 1];
    for (std::size_t j = 0; j < ids.size(); ++j) {
      if (ids[j] < ids[i]) continue;
      const auto at = std::lower_bound(begin, end, ids[j]);
      mass.value[static_cast<std::size_t>(at - mass.column.begin())] +=
          element(static_cast<Index>(i), static_cast<Index>(j));
    }
  }
}

template <int dim>
MassMatrix assemble_mass(const Discretization<dim>& discretization,
                         const StiffnessMatrix<dim>& pattern, double density) {
  MassMatrix mass{pattern.row_start, pattern.column,
                  std::vector<double>(pattern.column.size(), 0.0)};
  const auto rule = mass_quadrature(discretization);
  const auto displacement = tabulate_displacement<dim>(
      discretization.shape, discretization.displacement_degree(), rule.points);
  const CellInterpolation<dim> geometry(
      discretization.shape, discretization.mapping_degree(), rule.points);
  for (std::size_t c = 0; c < discretization.cell_nodes.size(); ++c) {
    const auto cell =
        cell_geometry<dim>(discretization.cell_points[c], geometry);
    const Eigen::VectorXd weights = density * discretization.thickness *
                                    rule.weights.cwiseProduct(cell.determinant);
    add_element(discretization.cell_nodes[c],
                transposed_product(displacement.values,
                                   weights.asDiagonal() * displacement.values),
                mass);
  }
  return mass;
}

UpperTriangle free_equations(const MassMatrix& mass, int dim,
                             const EquationNumbers& numbers) {
  UpperTriangle upper;
  upper.row_start.push_back(0);
  const auto components = static_cast<std::size_t>(dim);
  for (std::size_t node = 0; node + 1 < mass.row_start.size(); ++node) {
    for (std::size_t a = 0; a < components; ++a) {
      if (numbers.equation[components * node + a] < 0) continue;
      for (int k = mass.row_start[node]; k < mass.row_start[node + 1]; ++k) {
        const auto at = static_cast<std::size_t>(k);
        const auto other = static_cast<std::size_t>(mass.column[at]);
        const int column = numbers.equation[components * other + a];
        if (column < 0) continue;
        upper.column.push_back(column);
        upper.value.push_back(mass.value[at]);
      }
      upper.row_start.push_back(entry_number(upper.column.size()));
    }
  }
  return upper;
}

UpperTriangle weighted_sum(const UpperTriangle& a, double s,
                           const UpperTriangle& b) {
  UpperTriangle sum = a;
  for (std::size_t row = 0; row + 1 < a.row_start.size(); ++row) {
    auto at = static_cast<std::size_t>(a.row_start[row]);
    for (int k = b.row_start[row]; k < b.row_start[row + 1]; ++k) {
      const auto from = static_cast<std::size_t>(k);
      while (a.column[at] != b.column[from]) ++at;
      sum.value[at] += s * b.value[from];
    }
  }
  return sum;
}

template MassMatrix assemble_mass<2>(const Discretization<2>&,
                                     const StiffnessMatrix<2>&, double);
template MassMatrix assemble_mass<3>(const Discretization<3>&,
                                     const StiffnessMatrix<3>&, double);

}  // namespace clevis::elasticity
