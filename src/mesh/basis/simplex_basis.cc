#include "mesh/basis/simplex_basis.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include <Eigen/LU>

#include "mesh/basis/tensor_basis.h"

namespace clevis::mesh {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Barycentric coordinates of Isaac's node with these indices.
std::vector<double> recursive_node(const std::vector<int>& index) {
  const std::size_t n = index.size();
  if (n == 1) return {1.0};
  const int degree = std::accumulate(index.begin(), index.end(), 0);
  if (degree == 0) return std::vector<double>(n, 1.0 / double(n));
  const Eigen::VectorXd lobatto = gauss_lobatto(degree);
  std::vector<double> node(n, 0.0);
  double sum = 0.0;
  for (std::size_t left_out = 0; left_out < n; ++left_out) {
    const double weight = lobatto[degree - index[left_out]];
    if (weight == 0.0) continue;
    std::vector<int> rest = index;
    rest.erase(rest.begin() + std::ptrdiff_t(left_out));
    const auto on_face = recursive_node(rest);
    for (std::size_t i = 0, from = 0; i < n; ++i) {
      if (i != left_out) node[i] += weight * on_face[from++];
    }
    sum += weight;
  }
  for (double& x : node) x /= sum;
  return node;
}

/// x^n / n!, and its derivative.
struct ScaledPowers {
  ScaledPowers(double x, int degree) : power(std::size_t(degree) + 1, 1.0) {
    for (std::size_t k = 1; k < power.size(); ++k) {
      power[k] = power[k - 1] * x / double(k);
    }
  }
  double value(int n) const { return power[std::size_t(n)]; }
  double slope(int n) const { return n > 0 ? power[std::size_t(n) - 1] : 0.0; }

  std::vector<double> power;
};

double factorial(int n) {
  return n < 2 ? 1.0 : n * factorial(n - 1);
}

}  // namespace

template <int dim>
std::vector<SimplexIndex<dim>> simplex_lattice(int degree) {
  std::vector<SimplexIndex<dim>> lattice;
  const int layers = dim > 2 ? degree : 0, rows = dim > 1 ? degree : 0;
  for (int k = 0; k <= layers; ++k) {
    for (int j = 0; j <= rows - k || j == 0; ++j) {
      for (int i = 0; i <= degree - j - k; ++i) {
        const std::array<int, 4> at = {degree - i - j - k, i, j, k};
        auto& index = lattice.emplace_back();
        std::copy_n(at.begin(), dim + 1, index.begin());
      }
    }
  }
  return lattice;
}

template <int dim>
SimplexPoints<dim> simplex_nodes(int degree) {
  const auto lattice = simplex_lattice<dim>(degree);
  SimplexPoints<dim> nodes(dim, Index(lattice.size()));
  for (std::size_t i = 0; i < lattice.size(); ++i) {
    const auto node = recursive_node({lattice[i].begin(), lattice[i].end()});
    for (int d = 0; d < dim; ++d) {
      nodes(d, Index(i)) = node[std::size_t(d) + 1];
    }
  }
  return nodes;
}

template <int dim>
SimplexTable<dim> bernstein(int degree, const SimplexPoints<dim>& points) {
  const auto lattice = simplex_lattice<dim>(degree);
  const double scale = factorial(degree);
  SimplexTable<dim> table;
  table.value.resize(points.cols(), Index(lattice.size()));
  for (auto& slope : table.slope) slope = table.value;
  for (Index q = 0; q < points.cols(); ++q) {
    std::vector<ScaledPowers> along;
    along.emplace_back(1.0 - points.col(q).sum(), degree);
    for (int d = 0; d < dim; ++d) along.emplace_back(points(d, q), degree);
    for (std::size_t f = 0; f < lattice.size(); ++f) {
      // The product over the vertices, one factor replaced by its slope.
      const auto product = [&](std::size_t differentiated) {
        double value = scale;
        for (std::size_t v = 0; v <= std::size_t(dim); ++v) {
          value *= v == differentiated ? along[v].slope(lattice[f][v])
                                       : along[v].value(lattice[f][v]);
        }
        return value;
      };
      table.value(q, Index(f)) = product(std::size_t(dim) + 1);
      const double along_first = product(0);
      for (std::size_t d = 0; d < std::size_t(dim); ++d) {
        table.slope[d](q, Index(f)) = product(d + 1) - along_first;
      }
    }
  }
  return table;
}

template <int dim>
SimplexTable<dim> simplex_lagrange(int degree,
                                   const SimplexPoints<dim>& points) {
  const MatrixXd to_bernstein =
      bernstein<dim>(degree, simplex_nodes<dim>(degree)).value.inverse();
  SimplexTable<dim> table = bernstein<dim>(degree, points);
  table.value *= to_bernstein;
  for (auto& slope : table.slope) slope *= to_bernstein;
  return table;
}

template <int dim>
MappedGrid<dim> map_simplex(const SimplexPoints<dim>& cell_points,
                            const SimplexTable<dim>& table) {
  MappedGrid<dim> grid;
  grid.points = cell_points * table.value.transpose();
  for (std::size_t d = 0; d < std::size_t(dim); ++d) {
    grid.tangents[d] = cell_points * table.slope[d].transpose();
  }
  return grid;
}

template <int dim>
std::optional<Eigen::Matrix<double, dim, dim>> affine_edges(
    const SimplexPoints<dim>& cell_points, const SimplexPoints<dim>& nodes) {
  Eigen::Matrix<double, dim, dim> edges =
      Eigen::Matrix<double, dim, dim>::Zero();
  for (Index q = 0; q < nodes.cols(); ++q) {
    Index axis = 0;
    if (nodes.col(q).maxCoeff(&axis) == 1.0) {
      edges.col(axis) = cell_points.col(q) - cell_points.col(0);
    }
  }
  const double off =
      ((edges * nodes).colwise() + cell_points.col(0) - cell_points)
          .cwiseAbs()
          .maxCoeff();
  if (!(off <= 1e-13 * edges.cwiseAbs().maxCoeff())) return std::nullopt;
  return edges;
}

template <int dim>
std::vector<std::array<int, dim + 1>> simplex_parts(int n) {
  const auto lattice = simplex_lattice<dim>(n);
  std::map<SimplexIndex<dim>, int> position;
  for (std::size_t i = 0; i < lattice.size(); ++i) {
    position[lattice[i]] = int(i);
  }
  // Tail sums map the lattice to n >= s_0 >= s_1 …, of which Kuhn's simplices
  // of the unit cubes fill a part exactly.
  using Sums = std::array<int, std::size_t(dim)>;
  const auto find = [&](const Sums& sums) {
    SimplexIndex<dim> index{};
    index[0] = n - sums[0];
    for (std::size_t d = 0; d < sums.size(); ++d) {
      index[d + 1] = sums[d] - (d + 1 < sums.size() ? sums[d + 1] : 0);
    }
    const auto found = position.find(index);
    return found == position.end() ? -1 : found->second;
  };
  std::vector<std::array<int, dim + 1>> parts;
  for (const auto& origin : lattice) {
    Sums start{};
    for (std::size_t d = start.size(); d-- > 0;) {
      start[d] = origin[d + 1] + (d + 1 < start.size() ? start[d + 1] : 0);
    }
    std::array<std::size_t, std::size_t(dim)> axes{};
    std::iota(axes.begin(), axes.end(), std::size_t{0});
    do {
      std::array<int, dim + 1> part{};
      Sums at = start;
      bool inside = true;
      for (std::size_t v = 0; v < part.size(); ++v) {
        if (v > 0) ++at[axes[v - 1]];
        part[v] = find(at);
        inside = inside && part[v] >= 0;
      }
      if (!inside) continue;
      int swaps = 0;
      for (std::size_t a = 0; a < axes.size(); ++a) {
        for (std::size_t b = a + 1; b < axes.size(); ++b) {
          swaps += axes[a] > axes[b];
        }
      }
      if (swaps % 2 == 1) std::swap(part[dim - 1], part[dim]);
      parts.push_back(part);
    } while (std::next_permutation(axes.begin(), axes.end()));
  }
  return parts;
}

template <>
const std::array<int, 2>& simplex_face<2>(int face) {
  static constexpr std::array<std::array<int, 2>, 3> kFaces = {
      {{0, 1}, {1, 2}, {2, 0}}};
  return kFaces[std::size_t(face)];
}

template <>
const std::array<int, 3>& simplex_face<3>(int face) {
  static constexpr std::array<std::array<int, 3>, 4> kFaces = {
      {{0, 1, 2}, {1, 0, 3}, {0, 2, 3}, {2, 1, 3}}};
  return kFaces[std::size_t(face)];
}

double simplex_face_sense(int face) {
  // With the vertex left out in front, an even permutation looks outward.
  const auto& v = simplex_face<3>(face);
  const std::array<int, 4> all = {6 - v[0] - v[1] - v[2], v[0], v[1], v[2]};
  int swaps = 0;
  for (std::size_t a = 0; a < 4; ++a) {
    for (std::size_t b = a + 1; b < 4; ++b) swaps += all[a] > all[b];
  }
  return swaps % 2 == 0 ? 1.0 : -1.0;
}

template <int dim>
std::vector<int> simplex_face_lattice(int degree, int face) {
  const auto lattice = simplex_lattice<dim>(degree);
  std::vector<int> on_face;
  for (const auto& index : simplex_lattice<dim - 1>(degree)) {
    SimplexIndex<dim> wanted{};
    for (std::size_t v = 0; v < std::size_t(dim); ++v) {
      wanted[std::size_t(simplex_face<dim>(face)[v])] = index[v];
    }
    on_face.push_back(int(std::find(lattice.begin(), lattice.end(), wanted) -
                          lattice.begin()));
  }
  return on_face;
}

#define CLEVIS_INSTANTIATE(dim)                                                \
  template std::vector<SimplexIndex<dim>> simplex_lattice<dim>(int);           \
  template SimplexPoints<dim> simplex_nodes<dim>(int);                         \
  template SimplexTable<dim> bernstein<dim>(int, const SimplexPoints<dim>&);   \
  template SimplexTable<dim> simplex_lagrange<dim>(int,                        \
                                                   const SimplexPoints<dim>&); \
  template MappedGrid<dim> map_simplex<dim>(const SimplexPoints<dim>&,         \
                                            const SimplexTable<dim>&);         \
  template std::vector<std::array<int, dim + 1>> simplex_parts<dim>(int);      \
  template std::optional<Eigen::Matrix<double, dim, dim>> affine_edges<dim>(   \
      const SimplexPoints<dim>&, const SimplexPoints<dim>&);                   \
  template std::vector<int> simplex_face_lattice<dim>(int, int);
CLEVIS_INSTANTIATE(2)
CLEVIS_INSTANTIATE(3)
#undef CLEVIS_INSTANTIATE
template std::vector<SimplexIndex<1>> simplex_lattice<1>(int);

}  // namespace clevis::mesh
