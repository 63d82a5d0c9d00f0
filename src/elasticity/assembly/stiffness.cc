#include "elasticity/assembly/stiffness.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "base/messages/errors.h"
#include "elasticity/algebra/symmetric_product.h"
#include "elasticity/assembly/gradient_products.h"
#include "elasticity/assembly/node_pairs.h"

namespace clevis::elasticity {
namespace {

/// K_ij(a, b) = λ G_ab(i,j) + μ G_ba(i,j) + δ_ab μ Σ_c G_cc(i,j), where
/// G_ba(i,j) = G_ab(j,i).
template <int dim>
typename StiffnessMatrix<dim>::Block element_block(
    const GradientProducts<dim>& products, const LameConstants<dim>& lame,
    Eigen::Index i, Eigen::Index j) {
  const auto product = [&](std::size_t a, std::size_t b) {
    return products(a, b, i, j);
  };
  typename StiffnessMatrix<dim>::Block block;
  double trace = 0.0;
  for (std::size_t c = 0; c < dim; ++c) trace += product(c, c);
  for (std::size_t a = 0; a < dim; ++a) {
    for (std::size_t b = 0; b < dim; ++b) {
      block(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)) =
          lame.lambda * product(a, b) + lame.mu * product(b, a) +
          (a == b ? lame.mu * trace : 0.0);
    }
  }
  return block;
}

template <int dim>
void scatter(const std::vector<int>& ids, const GradientProducts<dim>& products,
             const LameConstants<dim>& lame, StiffnessMatrix<dim>& matrix) {
  std::vector<Eigen::Index> sorted(ids.size());
  std::iota(sorted.begin(), sorted.end(), 0);
  std::ranges::sort(sorted, {}, [&](Eigen::Index i) {
    return ids[static_cast<std::size_t>(i)];
  });
  for (std::size_t r = 0; r < sorted.size(); ++r) {
    const int row = ids[static_cast<std::size_t>(sorted[r])];
    auto at = static_cast<std::size_t>(
        matrix.row_start[static_cast<std::size_t>(row)]);
    for (std::size_t s = r; s < sorted.size(); ++s) {
      const int column = ids[static_cast<std::size_t>(sorted[s])];
      while (matrix.column[at] != column) ++at;
      matrix.block[at] +=
          element_block<dim>(products, lame, sorted[r], sorted[s]);
    }
  }
}

}  // namespace

void require_positive(const Eigen::VectorXd& determinant, std::size_t cell,
                      int degree, const std::string& place) {
  if (determinant.minCoeff() > 0.0) return;  // NaN falls through
  throw Error("M005", place,
              fmt::format("cell {} folds when its geometry is interpolated "
                          "with degree {}",
                          cell, degree),
              "Mesh the place finer.");
}

template <int dim>
Quadrature<dim> stiffness_quadrature(
    const Discretization<dim>& discretization) {
  const bool curved = discretization.geometry_degree > 1;
  const int more = discretization.shape == mesh::CellShape::kTensor && curved;
  return gauss<dim>(discretization.shape,
                    {discretization.degree + 1 + more,
                     discretization.thickness_degree + 1 + more});
}

template <int dim>
LameConstants<dim> lame_constants(const part::Material& material) {
  const double E = material.youngs_modulus;
  const double nu = material.poissons_ratio;
  const double mu = E / (2.0 * (1.0 + nu));
  if constexpr (dim == 2) return {E * nu / (1.0 - nu * nu), mu};
  return {E * nu / ((1.0 + nu) * (1.0 - 2.0 * nu)), mu};
}

template <int dim>
StiffnessMatrix<dim> StiffnessMatrix<dim>::absolute() const {
  StiffnessMatrix result = *this;
  for (Block& entries : result.block) entries = entries.cwiseAbs().eval();
  return result;
}

template <int dim>
Eigen::MatrixXd StiffnessMatrix<dim>::multiply(const Eigen::MatrixXd& x) const {
  static_assert(sizeof(Block) == dim * dim * sizeof(double));
  const double* entries = block.empty() ? nullptr : block.front().data();
  return symmetric_product(
      {dim, nodes(), row_start.data(), column.data(), entries}, x);
}

template <int dim>
bool folds(const Discretization<dim>& discretization) {
  const auto rule = stiffness_quadrature(discretization);
  const CellInterpolation<dim> geometry(
      discretization.shape, discretization.mapping_degree(), rule.points);
  return std::ranges::any_of(
      discretization.cell_points, [&](const auto& points) {
        return !(cell_geometry<dim>(points, geometry).determinant.minCoeff() >
                 0.0);
      });
}

template <int dim>
StiffnessMatrix<dim> assemble_stiffness(
    const Discretization<dim>& discretization, const part::Material& material,
    const std::string& place) {
  StiffnessMatrix<dim> matrix;
  NodePairs pairs = node_pairs(discretization.cell_nodes, discretization.nodes);
  matrix.row_start = std::move(pairs.row_start);
  matrix.column = std::move(pairs.column);
  matrix.block.assign(matrix.column.size(),
                      StiffnessMatrix<dim>::Block::Zero());
  const auto lame = lame_constants<dim>(material);
  const auto rule = stiffness_quadrature(discretization);
  const CellInterpolation<dim> geometry(
      discretization.shape, discretization.mapping_degree(), rule.points);
  GradientIntegrator<dim> integrator(discretization, rule);
  for (std::size_t c = 0; c < discretization.cell_nodes.size(); ++c) {
    const auto cell =
        cell_geometry<dim>(discretization.cell_points[c], geometry);
    require_positive(cell.determinant, c, discretization.geometry_degree,
                     place);
    const Eigen::VectorXd weights =
        rule.weights.cwiseProduct(cell.determinant) * discretization.thickness;
    scatter<dim>(discretization.cell_nodes[c],
                 integrator.integrate(cell, weights), lame, matrix);
  }
  return matrix;
}

template Quadrature<2> stiffness_quadrature<2>(const Discretization<2>&);
template Quadrature<3> stiffness_quadrature<3>(const Discretization<3>&);
template LameConstants<2> lame_constants<2>(const part::Material&);
template LameConstants<3> lame_constants<3>(const part::Material&);
template struct StiffnessMatrix<2>;
template struct StiffnessMatrix<3>;
template bool folds<2>(const Discretization<2>&);
template bool folds<3>(const Discretization<3>&);
template StiffnessMatrix<2> assemble_stiffness<2>(const Discretization<2>&,
                                                  const part::Material&,
                                                  const std::string&);
template StiffnessMatrix<3> assemble_stiffness<3>(const Discretization<3>&,
                                                  const part::Material&,
                                                  const std::string&);

}  // namespace clevis::elasticity
