#include "elasticity/assembly/stiffness.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "base/messages/errors.h"
#include "base/system/processor_share.h"
#include "elasticity/algebra/even_runs.h"
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

/// Every so many-th row is a slice's: those of neighbouring cells are shared
/// out evenly.
constexpr std::ptrdiff_t kSlices = 32;

/// Rows of some slices.
struct Slices {
  std::ptrdiff_t from = 0, to = kSlices;

  bool have(int row) const {
    const std::ptrdiff_t slice = row % kSlices;
    return slice >= from && slice < to;
  }
};

template <int dim>
void scatter(const std::vector<int>& ids, const GradientProducts<dim>& products,
             const LameConstants<dim>& lame, const Slices& slices,
             StiffnessMatrix<dim>& matrix) {
  std::vector<Eigen::Index> sorted(ids.size());
  std::iota(sorted.begin(), sorted.end(), 0);
  std::ranges::sort(sorted, {}, [&](Eigen::Index i) {
    return ids[static_cast<std::size_t>(i)];
  });
  for (std::size_t r = 0; r < sorted.size(); ++r) {
    const int row = ids[static_cast<std::size_t>(sorted[r])];
    if (!slices.have(row)) continue;
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

/// Integrates cells of a discretisation one by one.
template <int dim>
class ElementIntegrals {
 public:
  ElementIntegrals(const Discretization<dim>& discretization,
                   const std::string& place)
      : discretization_(discretization),
        place_(place),
        rule_(stiffness_quadrature(discretization)),
        geometry_(discretization.shape, discretization.mapping_degree(),
                  rule_.points),
        integrator_(discretization, rule_) {}

  /// @return until the next call. @throws Error M005.
  const GradientProducts<dim>& of(std::size_t c) {
    const auto cell =
        cell_geometry<dim>(discretization_.cell_points[c], geometry_);
    require_positive(cell.determinant, c, discretization_.geometry_degree,
                     place_);
    return integrator_.integrate(cell,
                                 rule_.weights.cwiseProduct(cell.determinant) *
                                     discretization_.thickness);
  }

 private:
  const Discretization<dim>& discretization_;
  const std::string& place_;
  Quadrature<dim> rule_;
  CellInterpolation<dim> geometry_;
  GradientIntegrator<dim> integrator_;
};

/// By all processors: a block of cells is integrated, then added by slices of
/// the rows. Each entry's sum has the order of the cells, whoever adds it.
template <int dim>
void add_in_blocks(const Discretization<dim>& discretization,
                   const LameConstants<dim>& lame, const std::string& place,
                   StiffnessMatrix<dim>& matrix) {
  constexpr std::size_t kBlock = 32 << 20;  // of integrals [byte]
  constexpr std::ptrdiff_t kFewest = 16;    // cells of a thread
  const auto& cells = discretization.cell_nodes;
  const std::size_t nodes = cells.front().size();
  const std::size_t bytes =
      dim * (dim + 1) / 2 * nodes * nodes * sizeof(double);
  const auto size =
      static_cast<std::ptrdiff_t>(std::max<std::size_t>(kBlock / bytes, 64));
  std::vector<GradientProducts<dim>> integrals(
      static_cast<std::size_t>(std::min(size, std::ssize(cells))));
  for (std::ptrdiff_t begin = 0; begin < std::ssize(cells); begin += size) {
    const std::ptrdiff_t count = std::min(size, std::ssize(cells) - begin);
    in_even_runs(count, kFewest, [&](std::ptrdiff_t from, std::ptrdiff_t to) {
      ElementIntegrals<dim> elements(discretization, place);
      for (std::ptrdiff_t c = from; c < to; ++c) {
        integrals[static_cast<std::size_t>(c)] =
            elements.of(static_cast<std::size_t>(begin + c));
      }
      return true;
    });
    in_even_runs(kSlices, 1, [&](std::ptrdiff_t from, std::ptrdiff_t to) {
      for (std::ptrdiff_t c = 0; c < count; ++c) {
        scatter<dim>(cells[static_cast<std::size_t>(begin + c)],
                     integrals[static_cast<std::size_t>(c)], lame,
                     Slices{from, to}, matrix);
      }
      return true;
    });
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
  constexpr std::size_t kMany = 64;
  if (own_processors() > 1 && discretization.cell_nodes.size() >= kMany) {
    add_in_blocks(discretization, lame, place, matrix);
    return matrix;
  }
  ElementIntegrals<dim> elements(discretization, place);
  for (std::size_t c = 0; c < discretization.cell_nodes.size(); ++c) {
    scatter<dim>(discretization.cell_nodes[c], elements.of(c), lame, Slices{},
                 matrix);
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
