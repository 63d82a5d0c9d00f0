#include "stress/peaks/meeting_points.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "elasticity/fe_space/tabulation.h"
#include "mesh/basis/simplex_basis.h"
#include "stress/field/stress_history.h"

namespace clevis::stress {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Vertices with their integer weights at a lattice point, ascending; unused
/// places are last. The same from every cell that the point belongs to.
template <int dim>
using PointKey = std::array<std::pair<int, int>, std::size_t{1} << dim>;

/// Weights of a cell's vertices at the points of its lattice.
template <int dim>
std::vector<std::vector<int>> vertex_weights(mesh::CellShape shape,
                                             int subdivisions) {
  std::vector<std::vector<int>> weights;
  if (shape == mesh::CellShape::kSimplex) {
    for (const auto& index : mesh::simplex_lattice<dim>(subdivisions)) {
      weights.emplace_back(index.begin(), index.end());
    }
    return weights;
  }
  const int n = subdivisions + 1;
  int points = 1;
  for (int d = 0; d < dim; ++d) points *= n;
  for (int point = 0; point < points; ++point) {
    auto& of_point = weights.emplace_back();
    for (unsigned vertex = 0; vertex < 1U << dim; ++vertex) {
      int weight = 1;
      for (int d = 0, rest = point; d < dim; ++d, rest /= n) {
        const int at = rest % n;
        weight *= ((vertex >> d) & 1U) != 0 ? at : subdivisions - at;
      }
      of_point.push_back(weight);
    }
  }
  return weights;
}

/// Places of a cell's vertices among its nodes, the first direction's first.
template <int dim>
std::vector<std::size_t> vertex_places(
    const elasticity::Discretization<dim>& discretization) {
  const auto points = elasticity::displacement_support_points<dim>(
      discretization.shape, discretization.displacement_degree());
  const auto place_at = [&](const Eigen::Matrix<double, dim, 1>& corner) {
    Index place = 0;
    [[maybe_unused]] const double distance =
        (points.colwise() - corner).colwise().norm().minCoeff(&place);
    assert(distance < 1e-9);
    return static_cast<std::size_t>(place);
  };
  std::vector<std::size_t> places;
  using Corner = Eigen::Matrix<double, dim, 1>;
  if (discretization.shape == mesh::CellShape::kSimplex) {
    places.push_back(place_at(Corner::Zero()));
    for (int d = 0; d < dim; ++d) places.push_back(place_at(Corner::Unit(d)));
    return places;
  }
  for (unsigned vertex = 0; vertex < 1U << dim; ++vertex) {
    Corner corner;
    for (int d = 0; d < dim; ++d) corner[d] = (vertex >> d) & 1U;
    places.push_back(place_at(corner));
  }
  return places;
}

}  // namespace

template <int dim>
MeetingPoints meeting_points(
    const elasticity::Discretization<dim>& discretization,
    std::vector<int> cells, int subdivisions) {
  const auto weights = vertex_weights<dim>(discretization.shape, subdivisions);
  const auto places = vertex_places<dim>(discretization);
  MeetingPoints result;
  result.number.resize(static_cast<Index>(weights.size()),
                       static_cast<Index>(cells.size()));
  std::map<PointKey<dim>, int> numbers;
  constexpr std::pair<int, int> kUnused = {std::numeric_limits<int>::max(), 0};
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const auto& nodes =
        discretization.cell_nodes[static_cast<std::size_t>(cells[k])];
    for (std::size_t q = 0; q < weights.size(); ++q) {
      PointKey<dim> key;
      key.fill(kUnused);
      for (std::size_t v = 0; v < places.size(); ++v) {
        if (weights[q][v] != 0) key[v] = {nodes[places[v]], weights[q][v]};
      }
      std::ranges::sort(key);
      const auto at = numbers.try_emplace(key, result.count);
      if (at.second) ++result.count;
      result.number(static_cast<Index>(q), static_cast<Index>(k)) =
          at.first->second;
    }
  }
  result.cells = std::move(cells);
  return result;
}

MeetingValues meeting_values(const MeetingPoints& points,
                             const MatrixXd& values) {
  constexpr double kHuge = std::numeric_limits<double>::infinity();
  VectorXd count = VectorXd::Zero(points.count);
  MeetingValues result{count, VectorXd::Constant(points.count, kHuge),
                       VectorXd::Constant(points.count, -kHuge)};
  for (Index k = 0; k < values.cols(); ++k) {
    for (Index q = 0; q < values.rows(); ++q) {
      const int n = points.number(q, k);
      const double value = values(q, k);
      count[n] += 1.0;
      result.mean[n] += value;
      result.low[n] = std::min(result.low[n], value);
      result.high[n] = std::max(result.high[n], value);
    }
  }
  result.mean.array() /= count.array();
  return result;
}

template <int dim>
JoinedStress joined_stress(const elasticity::DisplacementBasis<dim>& basis,
                           const part::Material& material, int subdivisions) {
  std::vector<int> cells(basis.discretization.cell_nodes.size());
  std::iota(cells.begin(), cells.end(), 0);
  const auto points =
      meeting_points<dim>(basis.discretization, std::move(cells), subdivisions);
  const auto history = stress_history<dim>(basis, material, subdivisions);
  const auto values = meeting_values(points, history.worst);
  JoinedStress joined{history.worst, history.worst};
  for (Index k = 0; k < joined.mean.cols(); ++k) {
    for (Index q = 0; q < joined.mean.rows(); ++q) {
      const int n = points.number(q, k);
      joined.mean(q, k) = values.mean[n];
      joined.jump(q, k) = values.high[n] - values.low[n];
    }
  }
  return joined;
}

#define CLEVIS_INSTANTIATE(dim)                                       \
  template MeetingPoints meeting_points<dim>(                         \
      const elasticity::Discretization<dim>&, std::vector<int>, int); \
  template JoinedStress joined_stress<dim>(                           \
      const elasticity::DisplacementBasis<dim>&, const part::Material&, int);
CLEVIS_INSTANTIATE(2)
CLEVIS_INSTANTIATE(3)
#undef CLEVIS_INSTANTIATE

}  // namespace clevis::stress
