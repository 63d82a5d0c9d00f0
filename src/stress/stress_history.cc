#include "stress/stress_history.h"

#include <cmath>
#include <string>

#include "elasticity/dense_product.h"
#include "elasticity/stiffness.h"

namespace clevis::stress {
namespace {

using Eigen::ArrayXXd;
using Eigen::Index;
using Eigen::MatrixXd;

template <int dim>
inline constexpr int kStressComponents = dim == 2 ? 3 : 6;

/// Stress at tabulated points of one cell, for all columns of the basis.
template <int dim>
class CellStress {
 public:
  CellStress(const elasticity::Discretization<dim>& discretization,
             const part::Material& material,
             const elasticity::ReferencePoints<dim>& points)
      : discretization_(discretization),
        lame_(elasticity::lame_constants<dim>(material)),
        displacement_(elasticity::tabulate_displacement<dim>(
            discretization.shape, discretization.degree, points)),
        geometry_(elasticity::tabulate_geometry<dim>(
            discretization.shape, discretization.geometry_degree, points)) {}

  /// Blocks of `points` rows: xx, yy, xy, or xx, yy, zz, xy, yz, xz.
  MatrixXd evaluate(std::size_t cell, const MatrixXd& columns) const {
    const auto n = displacement_.values.rows();
    const auto rank = columns.cols();
    const MatrixXd slopes = gradients(cell, columns);
    // slopes: row block d, column block a holds ∂u_a/∂x_d.
    const auto slope = [&](int a, int d) {
      return slopes.block(d * n, a * rank, n, rank);
    };
    MatrixXd trace = slope(0, 0);
    for (int d = 1; d < dim; ++d) trace += slope(d, d);
    MatrixXd stress(kStressComponents<dim> * n, rank);
    for (int d = 0; d < dim; ++d) {
      stress.middleRows(d * n, n) =
          lame_.lambda * trace + 2.0 * lame_.mu * slope(d, d);
    }
    for (int k = dim; k < kStressComponents<dim>; ++k) {
      const int a = k == 5 ? 0 : k - dim;  // xy, yz, xz
      const int b = k == 5 ? 2 : a + 1;
      stress.middleRows(k * n, n) = lame_.mu * (slope(a, b) + slope(b, a));
    }
    return stress;
  }

  MatrixXd positions(std::size_t cell) const {
    return geometry_.values * discretization_.cell_points[cell].transpose();
  }

  /// Displacement components, blocks of columns.
  MatrixXd displacements(std::size_t cell, const MatrixXd& columns) const {
    return elasticity::product(displacement_.values,
                               nodal_values(cell, columns));
  }

 private:
  MatrixXd nodal_values(std::size_t cell, const MatrixXd& columns) const {
    const auto& nodes = discretization_.cell_nodes[cell];
    MatrixXd values(static_cast<Index>(nodes.size()), dim * columns.cols());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      for (int a = 0; a < dim; ++a) {
        values.row(static_cast<Index>(i))
            .segment(a * columns.cols(), columns.cols()) =
            columns.row(dim * nodes[i] + a);
      }
    }
    return values;
  }

  MatrixXd gradients(std::size_t cell, const MatrixXd& columns) const {
    const auto at = elasticity::cell_geometry<dim>(
        discretization_.cell_points[cell], geometry_);
    const auto physical = elasticity::physical_gradients(at, displacement_);
    const auto n = displacement_.values.rows();
    MatrixXd stacked(dim * n, displacement_.values.cols());
    for (int d = 0; d < dim; ++d) {
      stacked.middleRows(d * n, n) = physical[static_cast<std::size_t>(d)];
    }
    return elasticity::product(stacked, nodal_values(cell, columns));
  }

  const elasticity::Discretization<dim>& discretization_;
  elasticity::LameConstants<dim> lame_;
  elasticity::Tabulation displacement_, geometry_;
};

/// Squares of von Mises, points × instants, of stress blocks as above.
template <int dim>
ArrayXXd von_mises_squared(const MatrixXd& stress, Index n) {
  const auto s = [&](int k) {
    return stress.middleRows(k * n, n).array();
  };
  if constexpr (dim == 2) {
    return s(0).square() - s(0) * s(1) + s(1).square() + 3.0 * s(2).square();
  } else {
    return 0.5 * ((s(0) - s(1)).square() + (s(1) - s(2)).square() +
                  (s(2) - s(0)).square()) +
           3.0 * (s(3).square() + s(4).square() + s(5).square());
  }
}

}  // namespace

template <int dim>
StressHistory stress_history(const elasticity::DisplacementBasis<dim>& basis,
                             const part::Material& material, int subdivisions) {
  const auto& discretization = basis.discretization;
  const auto points =
      elasticity::lattice<dim>(discretization.shape, subdivisions);
  const CellStress<dim> cell_stress(discretization, material, points);
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
            cell_stress.evaluate(static_cast<std::size_t>(c), basis.columns),
            basis.coefficients),
        n);
    for (Index q = 0; q < n; ++q) {
      Index instant = 0;
      result.worst(q, c) = squared.row(q).maxCoeff(&instant);
      result.worst_instant(q, c) = static_cast<int>(instant);
      if (result.worst(q, c) > largest_of_half && on_half_lattice(q)) {
        largest_of_half = result.worst(q, c);
      }
      if (result.worst(q, c) > largest) {
        largest = result.worst(q, c);
        result.peak_at = {c, static_cast<int>(q)};
        result.peak_instant = static_cast<int>(instant);
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
InstantField instant_field(const elasticity::DisplacementBasis<dim>& basis,
                           const part::Material& material, int subdivisions,
                           int instant) {
  const auto& discretization = basis.discretization;
  const auto points =
      elasticity::lattice<dim>(discretization.shape, subdivisions);
  const CellStress<dim> cell_stress(discretization, material, points);
  const Index n = points.cols();
  const MatrixXd u =
      elasticity::product(basis.columns, basis.coefficients.col(instant));
  InstantField field;
  field.subdivisions = subdivisions;
  for (std::size_t c = 0; c < discretization.cell_nodes.size(); ++c) {
    MatrixXd at = MatrixXd::Constant(n, 3, discretization.mid_plane_z);
    at.leftCols<dim>() = cell_stress.positions(c);
    MatrixXd displacement = MatrixXd::Zero(n, 3);
    displacement.leftCols<dim>() = cell_stress.displacements(c, u);
    const MatrixXd values = cell_stress.evaluate(c, u);
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
      discretization.shape, discretization.geometry_degree, point);
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
