#include "assessment/buckling/buckling_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/LU>
#include <fmt/format.h>

#include "elasticity/buckling/stressed_part.h"
#include "elasticity/plate/plate_layer.h"

namespace clevis::assessment {
namespace {

/// Longest edge of a cell over its smallest height at a corner [1]; regular
/// tetrahedron: 1.22, square: 1.
/// @param vertices  dim × corners.
/// @param joined  corners that an edge joins to each corner.
template <int dim>
double slenderness(
    const Eigen::Matrix<double, dim, Eigen::Dynamic>& vertices,
    const std::vector<std::array<int, static_cast<std::size_t>(dim)>>& joined,
    double height = HUGE_VAL) {
  double longest = 0.0, lowest = height;
  for (std::size_t c = 0; c < joined.size(); ++c) {
    Eigen::Matrix<double, dim, dim> edges;
    for (int k = 0; k < dim; ++k) {
      edges.col(k) = vertices.col(joined[c][static_cast<std::size_t>(k)]) -
                     vertices.col(static_cast<Eigen::Index>(c));
      longest = std::max(longest, edges.col(k).norm());
    }
    if (!(std::abs(edges.determinant()) > 0.0)) return HUGE_VAL;
    // The rows of the inverse are normal to the other edges.
    lowest =
        std::min(lowest, 1.0 / edges.inverse().rowwise().norm().maxCoeff());
  }
  return longest / lowest;
}

/// Whether 95 % of the cells are not long: of them degree 2 has bending and
/// twisting, and what is_compact() says holds.
/// @param height  of a layer of cells, which may be tall [m].
template <int dim>
bool has_compact_cells(const mesh::PartMesh<dim>& mesh,
                       double height = HUGE_VAL) {
  // A plate of one cell bends and twists with degree 2 worse than a bar: where
  // it is as thick as a third of its width it yields long before it buckles.
  const double long_cell = mesh.shape == mesh::CellShape::kSimplex ? 5.0 : 3.0;
  using Joined = std::vector<std::array<int, static_cast<std::size_t>(dim)>>;
  Joined joined;
  if constexpr (dim == 2) {
    joined = {{1, 2}, {0, 3}, {0, 3}, {1, 2}};
  } else if (mesh.shape == mesh::CellShape::kSimplex) {
    joined = {{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}};
  } else {
    joined = {{1, 2, 4}, {0, 3, 5}, {0, 3, 6}, {1, 2, 7},
              {0, 5, 6}, {1, 4, 7}, {2, 4, 7}, {3, 5, 6}};
  }
  const auto compact = std::ranges::count_if(mesh.cells, [&](const auto& cell) {
    Eigen::Matrix<double, dim, Eigen::Dynamic> vertices(
        dim, static_cast<Eigen::Index>(cell.size()));
    for (std::size_t v = 0; v < cell.size(); ++v) {
      vertices.col(static_cast<Eigen::Index>(v)) = mesh.vertices[cell[v]];
    }
    return slenderness<dim>(vertices, joined, height) < long_cell;
  });
  return static_cast<double>(compact) >=
         0.95 * static_cast<double>(mesh.cells.size());
}

}  // namespace

bool is_bearable(const Error& error) {
  return error.code() == "F001" || error.code() == "F002" ||
         error.code() == "F004" || error.code() == "F007" ||
         error.code() == "M005";
}

BucklingModel::BucklingModel(const PartJob& job)
    : job_(job),
      shape_(job),
      is_compact_(shape_.plate()
                      ? has_compact_cells(shape_.plate()->quadrangles,
                                          shape_.plate()->quadrangles.thickness)
                      : has_compact_cells(job.overall_mesh())) {}

PartSpace BucklingModel::discretize(int degree) const {
  constexpr int kThroughThickness = 3;  // warps as shear wants
  if (!shape_.plate()) {
    return {elasticity::discretize<3>(job_.overall_mesh(), degree)};
  }
  auto plane = elasticity::discretize<2>(shape_.plate()->quadrangles, degree);
  auto layer = elasticity::layer_over(plane, kThroughThickness);
  return {std::move(layer), std::move(plane)};
}

part::Supports BucklingModel::supports(const LoadSet& set) const {
  part::Supports fixed = set.fixed;
  const bool is_held_across =
      std::ranges::any_of(fixed, [](const auto& support) {
        return support.second[2];
      });
  if (!shape_.plate() || is_held_across) return fixed;
  for (auto& [group, components] : fixed) components[2] = true;
  return fixed;
}

void BucklingModel::factor(const LoadSet& set,
                           elasticity::BucklingProblem& problem) {
  constexpr int kSmall = 150'000;  // dofs: up to some 500 MB
  const bool is_kept = problem.discretization.degree == lowest_degree() &&
                       problem.discretization.dofs() < kSmall;
  const auto known = std::ranges::find_if(factored_, [&](const Factored& one) {
    return one.fixed == problem.fixed && one.foundations == set.foundations;
  });
  if (is_kept && known != factored_.end()) {
    problem.coordinates = known->coordinates;
    return;
  }
  problem.coordinates = elasticity::energy_coordinates(problem);
  if (!is_kept) return;
  factored_.push_back({problem.fixed, set.foundations, problem.coordinates});
}

std::string BucklingModel::name(int degree) const {
  const auto kind = shape_.plate() ? ModelKind::kLayered : ModelKind::kSolid;
  return fmt::format("{}, p = {}", traits_of(kind).name, degree);
}

}  // namespace clevis::assessment
