#include "stress/field/deflection.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "elasticity/algebra/dense_product.h"
#include "elasticity/assembly/supports.h"
#include "elasticity/fe_space/group_trace.h"
#include "elasticity/nodal_loads/load_vectors.h"
#include "stress/field/cell_field.h"

namespace clevis::stress {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Seats nearer than this, over the part's size, have no line between them to
/// speak of: their slip over the distance would be a turn of any size.
constexpr double kNearestSeats = 1e-3;

constexpr Index kBlock = 64;  // instants, so that few displacements are held

/// Mean displacement and mean rotation of a surface group per basis column.
template <int dim>
struct SurfaceMotion {
  Eigen::Matrix<double, dim, 1> centre;  ///< [m]
  MatrixXd translation;                  ///< dim × rank [m]
  MatrixXd rotation;                     ///< 1 or 3 × rank [rad]
};

using NodeWeights = std::map<int, double>;

/// Area ∫ N dA that belongs to each node of a group [m²].
template <int dim>
NodeWeights surface_weights(
    const elasticity::Discretization<dim>& discretization,
    const std::string& name) {
  const auto& groups = discretization.groups;
  const auto found = std::ranges::find(groups, name, &mesh::SurfaceGroup::name);
  elasticity::FaceTables<dim> tables;
  const auto trace = elasticity::group_trace(
      discretization, static_cast<int>(found - groups.begin()), tables);
  NodeWeights weights;
  Index begin = 0;
  for (const auto& face : trace.faces) {
    const Index n = face.values->rows();
    const Eigen::VectorXd areas =
        face.values->transpose() * trace.quadrature.weights.segment(begin, n);
    for (std::size_t k = 0; k < face.nodes.size(); ++k) {
      weights[face.nodes[k]] += areas[static_cast<Index>(k)];
    }
    begin += n;
  }
  return weights;
}

/// Volume ∫ N dV that belongs to each node [m³]: the mean does not depend on
/// where the mesh is fine.
template <int dim>
NodeWeights volume_weights(
    const elasticity::Discretization<dim>& discretization) {
  const Eigen::VectorXd volumes = elasticity::node_volumes<dim>(discretization);
  NodeWeights weights;
  for (Index node = 0; node < volumes.size(); ++node) {
    weights[static_cast<int>(node)] = volumes[node];
  }
  return weights;
}

/// Rigid motion nearest to the displacements of nodes, about their centre.
template <int dim>
SurfaceMotion<dim> mean_motion(
    const elasticity::DisplacementBasis<dim>& basis,
    const NodeWeights& node_weights,
    const Eigen::Matrix<double, dim, Eigen::Dynamic>& positions) {
  const auto n = static_cast<Index>(node_weights.size());
  Eigen::Matrix<double, dim, Eigen::Dynamic> at(dim, n);
  MatrixXd u(dim * n, basis.columns.cols());
  Eigen::VectorXd weights(dim * n);
  Index k = 0;
  for (const auto& [node, weight] : node_weights) {
    at.col(k) = positions.col(node);
    u.middleRows<dim>(dim * k) =
        basis.columns.template middleRows<dim>(dim * node);
    weights.segment<dim>(dim * k).setConstant(weight);
    ++k;
  }
  SurfaceMotion<dim> motion;
  motion.centre = Eigen::Matrix<double, dim, 1>::Zero();
  double total = 0.0;
  for (Index i = 0; i < n; ++i) {
    motion.centre += weights[dim * i] * at.col(i);
    total += weights[dim * i];
  }
  motion.centre /= total;
  const MatrixXd modes = elasticity::rigid_modes<dim>(at, motion.centre, 1.0);
  const MatrixXd weighted = weights.asDiagonal() * modes;
  const MatrixXd fit = (weighted.transpose() * modes)
                           .fullPivLu()
                           .solve(weighted.transpose() * u);
  motion.translation = fit.topRows<dim>();
  motion.rotation = fit.bottomRows(elasticity::kRigidModes<dim> - dim);
  return motion;
}

/// Rotation that keeps the second centre on the line; about the line itself
/// the first surface's own.
template <int dim>
MatrixXd line_rotation(const SurfaceMotion<dim>& first,
                       const SurfaceMotion<dim>& second) {
  const Eigen::Matrix<double, dim, 1> line = second.centre - first.centre;
  const MatrixXd relative = second.translation - first.translation;
  if constexpr (dim == 2) {
    const Eigen::RowVector2d normal(-line[1], line[0]);
    return normal * relative / line.squaredNorm();
  } else {
    const Eigen::Vector3d d = line.normalized();
    MatrixXd rotation = d * (d.transpose() * first.rotation);
    for (Index k = 0; k < relative.cols(); ++k) {
      const Eigen::Vector3d slip = relative.col(k);
      rotation.col(k) += line.cross(slip) / line.squaredNorm();
    }
    return rotation;
  }
}

/// Largest displacement of each node over all instants [m].
template <int dim>
Eigen::VectorXd largest_of_nodes(const MatrixXd& columns,
                                 const MatrixXd& coefficients) {
  Eigen::VectorXd largest = Eigen::VectorXd::Zero(columns.rows() / dim);
  for (Index begin = 0; begin < coefficients.cols(); begin += kBlock) {
    const Index count = std::min(kBlock, coefficients.cols() - begin);
    const MatrixXd u =
        elasticity::product(columns, coefficients.middleCols(begin, count));
    for (Index i = 0; i < count; ++i) {
      largest = largest.cwiseMax(u.col(i)
                                     .reshaped(dim, largest.size())
                                     .colwise()
                                     .squaredNorm()
                                     .transpose());
    }
  }
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
  double largest = -1.0;
  for (Index begin = 0; begin < coefficients.cols(); begin += kBlock) {
    const Index count = std::min(kBlock, coefficients.cols() - begin);
    const MatrixXd u =
        elasticity::product(columns, coefficients.middleCols(begin, count));
    for (Index i = 0; i < count; ++i) {
      Index node = 0;
      const double squared =
          u.col(i)
              .reshaped(directions, columns.rows() / directions)
              .colwise()
              .squaredNorm()
              .maxCoeff(&node);
      result.of_instant[begin + i] = std::sqrt(squared);
      if (squared <= largest) continue;
      largest = squared;
      result.node = node;
      result.instant = begin + i;
    }
  }
  result.value = std::sqrt(std::max(0.0, largest));
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
void remove_rigid_motion(elasticity::DisplacementBasis<dim>& basis,
                         const std::vector<std::string>& groups) {
  const auto positions = elasticity::node_positions(basis.discretization);
  std::vector<std::string> seat_groups;
  std::ranges::copy_if(
      groups, std::back_inserter(seat_groups), [&](const std::string& name) {
        return elasticity::has_faces(basis.discretization, name);
      });
  const auto motion_of = [&](const std::string& group) {
    return mean_motion<dim>(
        basis, surface_weights<dim>(basis.discretization, group), positions);
  };
  const auto first =
      seat_groups.empty()
          ? mean_motion<dim>(basis, volume_weights<dim>(basis.discretization),
                             positions)
          : motion_of(seat_groups.front());
  MatrixXd rotation = first.rotation;
  if (seat_groups.size() > 1) {
    const auto second = motion_of(seat_groups[1]);
    const double size =
        (positions.rowwise().maxCoeff() - positions.rowwise().minCoeff())
            .norm();
    if ((second.centre - first.centre).norm() > kNearestSeats * size) {
      rotation = line_rotation<dim>(first, second);
    }
  }
  MatrixXd rigid(elasticity::kRigidModes<dim>, rotation.cols());
  rigid << first.translation, rotation;
  basis.columns -= elasticity::product(
      elasticity::rigid_modes<dim>(positions, first.centre, 1.0), rigid);
}

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
  const Eigen::VectorXd largest = largest_of_nodes<dim>(
      basis.columns,
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

template void remove_rigid_motion<2>(elasticity::DisplacementBasis<2>&,
                                     const std::vector<std::string>&);
template void remove_rigid_motion<3>(elasticity::DisplacementBasis<3>&,
                                     const std::vector<std::string>&);
template Deflection largest_deflection<2>(
    const elasticity::DisplacementBasis<2>&);
template Deflection largest_deflection<3>(
    const elasticity::DisplacementBasis<3>&);
template double largest_deflection_of_many<2>(
    const elasticity::DisplacementBasis<2>&, int);
template double largest_deflection_of_many<3>(
    const elasticity::DisplacementBasis<3>&, int);

}  // namespace clevis::stress
