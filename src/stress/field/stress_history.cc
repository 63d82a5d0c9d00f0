#include "stress/field/stress_history.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "elasticity/algebra/dense_product.h"
#include "stress/field/cell_field.h"

namespace clevis::stress {
namespace {

using Eigen::ArrayXXd;
using Eigen::Index;
using Eigen::MatrixXd;

/// The points of a lattice that are evaluated, and of each point of the lattice
/// the evaluated one whose von Mises it has.
template <int dim>
struct Sampling {
  elasticity::ReferencePoints<dim> points;
  std::vector<Index> source;
};

/// All points; of a field that mirrors itself about the mid-plane of a layer
/// those of one half.
template <int dim>
Sampling<dim> sample(const elasticity::ReferencePoints<dim>& lattice,
                     bool is_mirrored) {
  constexpr double kSame = 1e-9;
  Sampling<dim> sampling{
      lattice, std::vector<Index>(static_cast<std::size_t>(lattice.cols()))};
  Index kept = 0;
  for (Index q = 0; q < lattice.cols(); ++q) {
    Eigen::Matrix<double, dim, 1> point = lattice.col(q);
    if (is_mirrored)
      point[dim - 1] = std::min(point[dim - 1], 1.0 - point[dim - 1]);
    Index at = is_mirrored ? 0 : kept;
    while (at < kept && (sampling.points.col(at) - point).norm() > kSame) ++at;
    if (at == kept) sampling.points.col(kept++) = point;
    sampling.source[static_cast<std::size_t>(q)] = at;
  }
  sampling.points.conservativeResize(Eigen::NoChange, kept);
  return sampling;
}

/// The largest value of each row and the column it stands in.
struct WorstColumns {
  Eigen::ArrayXd value, column;
};
WorstColumns worst_columns(const ArrayXXd& values) {
  const Index n = values.rows();
  WorstColumns worst{Eigen::ArrayXd::Constant(n, -1.0),
                     Eigen::ArrayXd::Zero(n)};
  double* value = worst.value.data();
  double* column = worst.column.data();
  for (Index i = 0; i < values.cols(); ++i) {  // down the columns: contiguous
    const double* at = values.col(i).data();
    const auto here = static_cast<double>(i);
    for (Index q = 0; q < n; ++q) {
      const bool higher = at[q] > value[q];
      value[q] = higher ? at[q] : value[q];
      column[q] = higher ? here : column[q];
    }
  }
  return worst;
}

}  // namespace

template <int dim>
StressHistory stress_history(const elasticity::DisplacementBasis<dim>& basis,
                             const part::Material& material, int subdivisions) {
  const auto& discretization = basis.discretization;
  const auto points =
      elasticity::lattice<dim>(discretization.shape, subdivisions);
  const auto sampling = sample<dim>(points, basis.is_mirrored);
  const CellField<dim> cell_field(discretization, material, sampling.points);
  const Index n = points.cols();
  const Index instants = basis.coefficients.cols();
  StressHistory result;
  result.subdivisions = subdivisions;
  result.worst.resize(n, discretization.cells());
  result.worst_instant.resize(n, discretization.cells());
  result.peak = Eigen::VectorXd::Zero(instants);
  double largest = -1.0;
  double largest_of_half = 0.0;
  const auto on_half_lattice = [&](Index q) {
    for (int d = 0; d < dim; ++d) {
      const double position = points(d, q) * subdivisions / 2.0;
      if (std::abs(position - std::round(position)) > 0.1) return false;
    }
    return true;
  };
  for (int c = 0; c < discretization.cells(); ++c) {
    const ArrayXXd squared = von_mises_squared<dim>(
        elasticity::product(
            cell_field.stress(static_cast<std::size_t>(c), basis.columns),
            basis.coefficients),
        sampling.points.cols());
    const WorstColumns worst = worst_columns(squared);
    auto when = result.worst_instant.col(c);
    for (Index q = 0; q < n; ++q) {
      const Index at = sampling.source[static_cast<std::size_t>(q)];
      result.worst(q, c) = worst.value[at];
      when[q] = static_cast<int>(worst.column[at]);
    }
    for (Index q = 0; q < n; ++q) {
      if (result.worst(q, c) > largest_of_half && on_half_lattice(q)) {
        largest_of_half = result.worst(q, c);
      }
      if (result.worst(q, c) > largest) {
        largest = result.worst(q, c);
        result.peak_at = {c, static_cast<int>(q)};
        result.peak_instant = when[q];
      }
    }
    result.peak =
        result.peak.cwiseMax(squared.colwise().maxCoeff().matrix().transpose());
  }
  if (subdivisions > 1) {
    result.sampling_error =
        (std::sqrt(largest) - std::sqrt(largest_of_half)) / 3.0;
  }
  result.worst = result.worst.cwiseSqrt();
  result.peak = result.peak.cwiseSqrt();
  return result;
}

template <int dim>
Eigen::VectorXd peaks_outside(const elasticity::DisplacementBasis<dim>& basis,
                              const part::Material& material, int subdivisions,
                              const Eigen::MatrixXi& zone_of) {
  const auto& discretization = basis.discretization;
  const auto points =
      elasticity::lattice<dim>(discretization.shape, subdivisions);
  const CellField<dim> cell_field(discretization, material, points);
  Eigen::VectorXd peak = Eigen::VectorXd::Zero(basis.coefficients.cols());
  for (int c = 0; c < discretization.cells(); ++c) {
    ArrayXXd squared = von_mises_squared<dim>(
        elasticity::product(
            cell_field.stress(static_cast<std::size_t>(c), basis.columns),
            basis.coefficients),
        points.cols());
    for (Index q = 0; q < points.cols(); ++q) {
      if (zone_of(q, c) >= 0) squared.row(q).setZero();
    }
    peak = peak.cwiseMax(squared.colwise().maxCoeff().matrix().transpose());
  }
  return peak.cwiseSqrt();
}

template <int dim>
InstantField instant_field(const elasticity::DisplacementBasis<dim>& basis,
                           const part::Material& material, int subdivisions,
                           int instant) {
  const auto& discretization = basis.discretization;
  const auto points =
      elasticity::lattice<dim>(discretization.shape, subdivisions);
  const CellField<dim> cell_field(discretization, material, points);
  const Index n = points.cols();
  const MatrixXd u =
      elasticity::product(basis.columns, basis.coefficients.col(instant));
  InstantField field;
  field.subdivisions = subdivisions;
  for (std::size_t c = 0; c < discretization.cell_nodes.size(); ++c) {
    MatrixXd at = MatrixXd::Constant(n, 3, discretization.mid_plane_z);
    at.leftCols<dim>() = cell_field.positions(c);
    MatrixXd displacement = MatrixXd::Zero(n, 3);
    displacement.leftCols<dim>() = cell_field.displacement(c, u);
    const MatrixXd values = cell_field.stress(c, u);
    MatrixXd stress = MatrixXd::Zero(n, 6);
    for (int k = 0; k < kStressComponents<dim>; ++k) {
      stress.col(dim == 2 && k == 2 ? 3 : k) = values.middleRows(k * n, n);
    }
    field.points.push_back(std::move(at));
    field.displacement.push_back(std::move(displacement));
    field.stress.push_back(std::move(stress));
  }
  return field;
}

Eigen::Matrix3d stress_tensor(const Eigen::Matrix<double, 1, 6>& row) {
  Eigen::Matrix3d stress;
  stress << row[0], row[3], row[5], row[3], row[1], row[4], row[5], row[4],
      row[2];
  return stress;
}

namespace {

/// By how much the parabola through the largest value and its neighbours
/// rises above it; 0 if it stands at an end.
double vertex_excess(const Eigen::VectorXd& peak) {
  Index at = 0;
  peak.maxCoeff(&at);
  if (at == 0 || at == peak.size() - 1) return 0.0;
  const double slope = 0.5 * (peak[at + 1] - peak[at - 1]);
  const double curvature = peak[at + 1] - 2.0 * peak[at] + peak[at - 1];
  return curvature < 0.0 ? -0.5 * slope * slope / curvature : 0.0;
}

}  // namespace

double time_sampling_error(const Eigen::VectorXd& peak) {
  const Index n = peak.size();
  if (n < 2) return 0.0;
  constexpr Index kFew = 12;
  if (n < kFew) return peak.maxCoeff() - peak.minCoeff();
  const double ends = std::max(peak[0], peak[n - 1]);
  double largest[2] = {ends, ends};
  for (Index i = 0; i < n; ++i) {
    largest[i % 2] = std::max(largest[i % 2], peak[i]);
  }
  return std::max(vertex_excess(peak), std::abs(largest[0] - largest[1]) / 3.0);
}

Eigen::VectorXd von_mises(const MatrixXd& stress) {
  const auto s = [&](int k) {
    return stress.col(k).array();
  };
  return (0.5 * ((s(0) - s(1)).square() + (s(1) - s(2)).square() +
                 (s(2) - s(0)).square()) +
          3.0 * (s(3).square() + s(4).square() + s(5).square()))
      .sqrt();
}

template <int dim>
Eigen::Vector3d position(const elasticity::Discretization<dim>& discretization,
                         FieldPoint at, int subdivisions) {
  const elasticity::ReferencePoints<dim> point =
      elasticity::lattice<dim>(discretization.shape, subdivisions)
          .col(at.point);
  const auto geometry = elasticity::tabulate_geometry<dim>(
      discretization.shape, discretization.mapping_degree(), point);
  Eigen::Vector3d result =
      Eigen::Vector3d::Constant(discretization.mid_plane_z);
  result.head<dim>() =
      discretization.cell_points[static_cast<std::size_t>(at.cell)] *
      geometry.values.row(0).transpose();
  return result;
}

template <int dim>
std::string surface_group(const elasticity::Discretization<dim>& discretization,
                          FieldPoint at, int subdivisions) {
  const Eigen::Matrix<double, dim, 1> point =
      elasticity::lattice<dim>(discretization.shape, subdivisions)
          .col(at.point);
  for (std::size_t g = 0; g < discretization.groups.size(); ++g) {
    for (const auto& [cell, face] : discretization.group_faces[g]) {
      if (cell != at.cell) continue;
      const auto rule =
          elasticity::face_gauss<dim>(discretization.shape, face, 1);
      const double distance = (point - rule.points.col(0)).dot(rule.outward);
      if (std::abs(distance) < 1e-9) return discretization.groups[g].name;
    }
  }
  // A corner of a cell may touch a bore that no face of the cell lies on.
  const Eigen::Vector3d where = position<dim>(discretization, at, subdivisions);
  for (const auto& group : discretization.groups) {
    if (!group.cylinder) continue;
    const Eigen::Vector3d arm = where - group.cylinder->p_LC;
    const double along = arm.dot(group.cylinder->axis_L);
    const double radius = (arm - along * group.cylinder->axis_L).norm();
    if (std::abs(radius - group.cylinder->radius) <
            1e-6 * group.cylinder->radius &&
        std::abs(along) < 0.51 * group.cylinder->length) {
      return group.name;
    }
  }
  return "body";
}

#define CLEVIS_INSTANTIATE(dim)                                               \
  template StressHistory stress_history<dim>(                                 \
      const elasticity::DisplacementBasis<dim>&, const part::Material&, int); \
  template Eigen::VectorXd peaks_outside<dim>(                                \
      const elasticity::DisplacementBasis<dim>&, const part::Material&, int,  \
      const Eigen::MatrixXi&);                                                \
  template InstantField instant_field<dim>(                                   \
      const elasticity::DisplacementBasis<dim>&, const part::Material&, int,  \
      int);                                                                   \
  template Eigen::Vector3d position<dim>(                                     \
      const elasticity::Discretization<dim>&, FieldPoint, int);               \
  template std::string surface_group<dim>(                                    \
      const elasticity::Discretization<dim>&, FieldPoint, int);
CLEVIS_INSTANTIATE(2)
CLEVIS_INSTANTIATE(3)
#undef CLEVIS_INSTANTIATE

}  // namespace clevis::stress
