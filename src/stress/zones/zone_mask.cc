#include "stress/zones/zone_mask.h"

#include <algorithm>
#include <cmath>

#include "stress/field/cell_field.h"

namespace clevis::stress {
namespace {

using Eigen::Index;

/// Whether a lattice point is one of every second in all directions.
bool on_half_lattice(Index point, int subdivisions, int dim) {
  for (int d = 0; d < dim; ++d) {
    if (point % (subdivisions + 1) % 2 != 0) return false;
    point /= subdivisions + 1;
  }
  return true;
}

/// Points beside each along the lattice.
template <int dim>
std::vector<std::vector<int>> neighbours(
    const elasticity::ReferencePoints<dim>& points, int subdivisions) {
  const double spacing = 1.01 / subdivisions;
  std::vector<std::vector<int>> found(static_cast<std::size_t>(points.cols()));
  for (Index q = 0; q < points.cols(); ++q) {
    for (Index r = 0; r < points.cols(); ++r) {
      if (r == q || (points.col(q) - points.col(r)).norm() > spacing) continue;
      found[static_cast<std::size_t>(q)].push_back(static_cast<int>(r));
    }
  }
  return found;
}

}  // namespace

template <int dim>
Eigen::MatrixXi zone_of_points(
    const elasticity::Discretization<dim>& discretization, int subdivisions,
    const std::vector<SingularZone>& zones) {
  const auto points =
      elasticity::lattice<dim>(discretization.shape, subdivisions);
  const auto geometry = elasticity::tabulate_geometry<dim>(
      discretization.shape, discretization.mapping_degree(), points);
  Eigen::MatrixXi zone_of =
      Eigen::MatrixXi::Constant(points.cols(), discretization.cells(), -1);
  for (Index c = 0; c < zone_of.cols(); ++c) {
    const Eigen::Matrix<double, dim, Eigen::Dynamic> at =
        discretization.cell_points[static_cast<std::size_t>(c)] *
        geometry.values.transpose();
    const double size =
        (at.rowwise().maxCoeff() - at.rowwise().minCoeff()).norm();
    Eigen::Vector3d x(0.0, 0.0, discretization.mid_plane_z);
    for (std::size_t z = zones.size(); z-- > 0;) {
      x.head<dim>() = at.col(0);
      if (distance(zones[z], x) > zones[z].radius + size) continue;
      for (Index q = 0; q < at.cols(); ++q) {
        x.head<dim>() = at.col(q);
        if (distance(zones[z], x) <= zones[z].radius) {
          zone_of(q, c) = static_cast<int>(z);
        }
      }
    }
  }
  return zone_of;
}

template <int dim>
std::vector<PointBeside> points_beside(
    const elasticity::Discretization<dim>& discretization, int subdivisions,
    const std::vector<SingularZone>& zones) {
  const auto points =
      elasticity::lattice<dim>(discretization.shape, subdivisions);
  const auto geometry = elasticity::tabulate_geometry<dim>(
      discretization.shape, discretization.mapping_degree(), points);
  const auto beside = neighbours<dim>(points, subdivisions);
  std::vector<PointBeside> found;
  for (int c = 0; c < discretization.cells(); ++c) {
    const Eigen::Matrix<double, dim, Eigen::Dynamic> at =
        discretization.cell_points[static_cast<std::size_t>(c)] *
        geometry.values.transpose();
    const double size =
        (at.rowwise().maxCoeff() - at.rowwise().minCoeff()).norm();
    Eigen::Vector3d x(0.0, 0.0, discretization.mid_plane_z);
    for (std::size_t z = 0; z < zones.size(); ++z) {
      const SingularZone& zone = zones[z];
      if (!(zone.radius > 0.0)) continue;
      // A logarithm's is not steeper than a crack's.
      const double steepest = zone.exponent < 1.0 ? 1.0 - zone.exponent : 0.5;
      x.head<dim>() = at.col(0);
      if (distance(zone, x) > zone.radius + 2.0 * size) continue;
      const auto away_of = [&](int q) {
        x.head<dim>() = at.col(q);
        return distance(zone, x) / zone.radius;
      };
      for (int q = 0; q < at.cols(); ++q) {
        const double away = away_of(q);
        if (away <= 1.0) continue;
        for (const int inside : beside[static_cast<std::size_t>(q)]) {
          const double inside_away = away_of(inside);
          if (inside_away > 1.0) continue;
          found.push_back({{c, q},
                           inside,
                           static_cast<int>(z),
                           away,
                           inside_away,
                           std::pow(away, steepest)});
        }
      }
    }
  }
  return found;
}

double excess_at_borders(const StressHistory& history,
                         const Eigen::MatrixXi& zone_of,
                         const std::vector<PointBeside>& beside,
                         const std::vector<bool>& left_out, double peak) {
  const auto counts = [&](int zone) {
    return zone < 0 || !left_out[static_cast<std::size_t>(zone)];
  };
  double excess = 0.0;
  for (const PointBeside& point : beside) {
    const auto [cell, q] = point.at;
    if (counts(point.zone) || !counts(zone_of(q, cell))) continue;
    const double value = history.worst(q, cell);
    const double within = history.worst(point.inside, cell);
    if (!(value > 0.0) || !(within > value)) continue;
    double growth = point.growth;
    // Nearer to the corner the elements show less than there is.
    constexpr double kShown = 0.25;
    if (point.inside_away > kShown) {
      const double power =
          std::log(within / value) / std::log(point.away / point.inside_away);
      growth = std::min(growth, std::pow(point.away, power));
    }
    excess = std::max(excess, growth * value - peak);
  }
  return excess;
}

PartialPeak peak_outside(const StressHistory& history,
                         const Eigen::MatrixXi& zone_of,
                         const std::vector<bool>& left_out, int dim) {
  PartialPeak peak;
  double half = 0.0;
  for (Index c = 0; c < zone_of.cols(); ++c) {
    for (Index q = 0; q < zone_of.rows(); ++q) {
      const int zone = zone_of(q, c);
      if (zone >= 0 && left_out[static_cast<std::size_t>(zone)]) continue;
      const double value = history.worst(q, c);
      if (value > half && on_half_lattice(q, history.subdivisions, dim)) {
        half = value;
      }
      if (value <= peak.value) continue;
      peak.value = value;
      peak.at = {static_cast<int>(c), static_cast<int>(q)};
      peak.instant = history.worst_instant(q, c);
    }
  }
  if (history.subdivisions > 1) peak.sampling_error = (peak.value - half) / 3.0;
  return peak;
}

std::vector<double> peaks_inside(const StressHistory& history,
                                 const Eigen::MatrixXi& zone_of,
                                 std::size_t zones) {
  std::vector<double> peaks(zones, 0.0);
  for (Index c = 0; c < zone_of.cols(); ++c) {
    for (Index q = 0; q < zone_of.rows(); ++q) {
      if (zone_of(q, c) < 0) continue;
      double& peak = peaks[static_cast<std::size_t>(zone_of(q, c))];
      peak = std::max(peak, history.worst(q, c));
    }
  }
  return peaks;
}

template <int dim>
Eigen::VectorXd point_history(const elasticity::DisplacementBasis<dim>& basis,
                              const part::Material& material, FieldPoint at,
                              int subdivisions) {
  const elasticity::ReferencePoints<dim> point =
      elasticity::lattice<dim>(basis.discretization.shape, subdivisions)
          .col(at.point);
  const CellField<dim> field(basis.discretization, material, point);
  const Eigen::MatrixXd values =
      field.stress(static_cast<std::size_t>(at.cell), basis.columns) *
      basis.coefficients;
  Eigen::MatrixXd stress = Eigen::MatrixXd::Zero(values.cols(), 6);
  for (int k = 0; k < kStressComponents<dim>; ++k) {
    stress.col(dim == 2 && k == 2 ? 3 : k) = values.row(k).transpose();
  }
  return von_mises(stress);
}

#define CLEVIS_INSTANTIATE(dim)                                         \
  template Eigen::MatrixXi zone_of_points<dim>(                         \
      const elasticity::Discretization<dim>&, int,                      \
      const std::vector<SingularZone>&);                                \
  template std::vector<PointBeside> points_beside<dim>(                 \
      const elasticity::Discretization<dim>&, int,                      \
      const std::vector<SingularZone>&);                                \
  template Eigen::VectorXd point_history<dim>(                          \
      const elasticity::DisplacementBasis<dim>&, const part::Material&, \
      FieldPoint, int);
CLEVIS_INSTANTIATE(2)
CLEVIS_INSTANTIATE(3)
#undef CLEVIS_INSTANTIATE

}  // namespace clevis::stress
