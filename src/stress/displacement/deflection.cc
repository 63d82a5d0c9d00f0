#include "stress/displacement/deflection.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "elasticity/algebra/dense_product.h"
#include "elasticity/assembly/supports.h"
#include "stress/field/cell_field.h"

namespace clevis::stress {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Visits the displacements of some nodes at some instants, after each other so
/// that few are held: visit(u, first node, first instant), u with directions of
/// nodes × instants [m].
/// @param columns  directions × nodes, per basis column [m].
template <typename Visit>
void visit_displacements(const MatrixXd& columns, Index directions,
                         const MatrixXd& coefficients, const Visit& visit) {
  constexpr Index kInstants = 64;
  const Index most_rows = 1024 * directions;
  for (Index row = 0; row < columns.rows(); row += most_rows) {
    const MatrixXd some =
        columns.middleRows(row, std::min(most_rows, columns.rows() - row));
    for (Index begin = 0; begin < coefficients.cols(); begin += kInstants) {
      const Index count = std::min(kInstants, coefficients.cols() - begin);
      visit(elasticity::product(some, coefficients.middleCols(begin, count)),
            row / directions, begin);
    }
  }
}

/// Squares of the displacements of nodes at an instant [m²].
auto squares(const MatrixXd& u, Index directions, Index instant) {
  return u.col(instant)
      .reshaped(directions, u.rows() / directions)
      .colwise()
      .squaredNorm();
}

/// Largest displacement of each node over all instants [m].
Eigen::VectorXd largest_of_nodes(const MatrixXd& columns, Index directions,
                                 const MatrixXd& coefficients) {
  Eigen::VectorXd largest = Eigen::VectorXd::Zero(columns.rows() / directions);
  visit_displacements(
      columns, directions, coefficients,
      [&](const MatrixXd& u, Index first, Index) {
        auto here = largest.segment(first, u.rows() / directions);
        for (Index i = 0; i < u.cols(); ++i) {
          here = here.cwiseMax(squares(u, directions, i).transpose());
        }
      });
  return largest.cwiseSqrt();
}

/// Largest displacement, and that of each instant [m].
struct LargestOfNodes {
  double value{};
  Index node{}, instant{};
  Eigen::VectorXd of_instant;
};

/// @param columns  directions × nodes, per basis column [m].
LargestOfNodes largest_of(const MatrixXd& columns, Index directions,
                          const MatrixXd& coefficients) {
  LargestOfNodes result;
  result.of_instant = Eigen::VectorXd::Zero(coefficients.cols());
  Eigen::VectorX<Index> nodes =
      Eigen::VectorX<Index>::Zero(coefficients.cols());
  visit_displacements(columns, directions, coefficients,
                      [&](const MatrixXd& u, Index first, Index begin) {
                        for (Index i = 0; i < u.cols(); ++i) {
                          Index node = 0;
                          const double squared =
                              squares(u, directions, i).maxCoeff(&node);
                          double& largest = result.of_instant[begin + i];
                          if (squared <= largest) continue;
                          largest = squared;
                          nodes[begin + i] = first + node;
                        }
                      });
  result.of_instant = result.of_instant.cwiseSqrt();
  result.value = result.of_instant.maxCoeff(&result.instant);
  result.node = nodes[result.instant];
  return result;
}

/// Area-weighted means over squares of half a plate's thickness. Across it a
/// plate moves by the stress about a place: that of a corner, which grows
/// without bound towards it, moves nothing so small.
class MeansOverSquares {
 public:
  explicit MeansOverSquares(double thickness) : side_(0.5 * thickness) {}

  /// Whether a cell is smaller than a square.
  bool is_smaller(const Eigen::Matrix2Xd& points) const {
    return sides(points).maxCoeff() < side_;
  }
  void add(const Eigen::Matrix2Xd& points, const Eigen::RowVectorXd& value) {
    const double area = sides(points).prod();
    auto [mean, is_new] = means_.try_emplace(
        square_of(points), 0.0, Eigen::RowVectorXd::Zero(value.size()));
    mean->second.first += area;
    mean->second.second += area * value;
  }
  Eigen::RowVectorXd at(const Eigen::Matrix2Xd& points) const {
    const auto& [area, sum] = means_.at(square_of(points));
    return sum / area;
  }

 private:
  static Eigen::Vector2d sides(const Eigen::Matrix2Xd& points) {
    return points.rowwise().maxCoeff() - points.rowwise().minCoeff();
  }
  std::pair<long, long> square_of(const Eigen::Matrix2Xd& points) const {
    const Eigen::Vector2d middle = points.rowwise().mean() / side_;
    return {std::lround(middle.x()), std::lround(middle.y())};
  }

  double side_;  ///< [m]
  std::map<std::pair<long, long>, std::pair<double, Eigen::RowVectorXd>> means_;
};

/// Motion of a plate's upper surface across it at the nodes, per basis column
/// [m].
MatrixXd rise_of_surface(const elasticity::DisplacementBasis<2>& basis,
                         const part::Material& material) {
  const auto& plate = basis.discretization;
  const auto points = elasticity::displacement_support_points<2>(
      plate.shape, plate.displacement_degree());
  const CellField<2> field(plate, material, points);
  const double factor = -0.5 * plate.thickness * material.poissons_ratio /
                        material.youngs_modulus;
  const Index n = points.cols();
  const auto positions = elasticity::node_positions(plate);
  const auto points_of = [&](std::size_t c) -> Eigen::Matrix2Xd {
    return positions(Eigen::all, plate.cell_nodes[c]);
  };
  const auto rise_of = [&](std::size_t c) -> MatrixXd {
    const MatrixXd stress = field.stress(c, basis.columns);
    return factor * (stress.topRows(n) + stress.middleRows(n, n));
  };
  MeansOverSquares means(plate.thickness);
  for (std::size_t c = 0; c < plate.cell_nodes.size(); ++c) {
    if (!means.is_smaller(points_of(c))) continue;
    means.add(points_of(c), rise_of(c).colwise().mean());
  }
  MatrixXd rise = MatrixXd::Zero(plate.nodes, basis.columns.cols());
  Eigen::VectorXd cells = Eigen::VectorXd::Zero(plate.nodes);
  for (std::size_t c = 0; c < plate.cell_nodes.size(); ++c) {
    const MatrixXd here = means.is_smaller(points_of(c))
                              ? MatrixXd(means.at(points_of(c)).replicate(n, 1))
                              : rise_of(c);
    for (Index k = 0; k < n; ++k) {
      const int node = plate.cell_nodes[c][static_cast<std::size_t>(k)];
      rise.row(node) += here.row(k);
      cells[node] += 1.0;
    }
  }
  return cells.cwiseMax(1.0).cwiseInverse().asDiagonal() * rise;
}

}  // namespace

template <int dim>
Deflection largest_deflection(const elasticity::DisplacementBasis<dim>& basis) {
  const auto found = largest_of(basis.columns, dim, basis.coefficients);
  Eigen::Vector3d at(0.0, 0.0, basis.discretization.mid_plane_z);
  at.template head<dim>() =
      elasticity::node_positions(basis.discretization).col(found.node);
  return {found.value, at, static_cast<int>(found.instant), found.of_instant};
}

Deflection largest_deflection_of_plate(
    const elasticity::DisplacementBasis<2>& basis,
    const part::Material& material) {
  const auto& plate = basis.discretization;
  MatrixXd columns(3 * Index{plate.nodes}, basis.columns.cols());
  const MatrixXd rise = rise_of_surface(basis, material);
  for (Index node = 0; node < plate.nodes; ++node) {
    columns.middleRows<2>(3 * node) = basis.columns.middleRows<2>(2 * node);
    columns.row(3 * node + 2) = rise.row(node);
  }
  const auto found = largest_of(columns, 3, basis.coefficients);
  Eigen::Vector3d at(0.0, 0.0, plate.mid_plane_z + 0.5 * plate.thickness);
  at.head<2>() = elasticity::node_positions(plate).col(found.node);
  return {found.value, at, static_cast<int>(found.instant), found.of_instant};
}

template <int dim>
double largest_deflection_of_many(
    const elasticity::DisplacementBasis<dim>& basis, int stride) {
  constexpr double kNear = 0.75;
  const Index instants = basis.coefficients.cols();
  const Eigen::VectorXd largest = largest_of_nodes(
      basis.columns, dim,
      basis.coefficients(Eigen::all,
                         Eigen::seqN(Index{0}, (instants + stride - 1) / stride,
                                     Index{stride})));
  const double least = kNear * largest.maxCoeff();
  std::vector<Index> rows;
  for (Index node = 0; node < largest.size(); ++node) {
    if (largest[node] < least) continue;
    for (Index d = 0; d < dim; ++d) rows.push_back(dim * node + d);
  }
  const MatrixXd u =
      elasticity::product(basis.columns(rows, Eigen::all), basis.coefficients);
  return u.reshaped(dim, u.size() / dim).colwise().norm().maxCoeff();
}

template Deflection largest_deflection<2>(
    const elasticity::DisplacementBasis<2>&);
template Deflection largest_deflection<3>(
    const elasticity::DisplacementBasis<3>&);
template double largest_deflection_of_many<2>(
    const elasticity::DisplacementBasis<2>&, int);
template double largest_deflection_of_many<3>(
    const elasticity::DisplacementBasis<3>&, int);

}  // namespace clevis::stress
