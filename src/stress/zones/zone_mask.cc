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

/// Points beside each along a cell's lattice.
template <int dim>
std::vector<std::vector<int>> neighbours(mesh::CellShape shape,
                                         int subdivisions) {
  const double spacing = 1.01 / subdivisions;
  const auto points = elasticity::lattice<dim>(shape, subdivisions);
  std::vector<std::vector<int>> found(static_cast<std::size_t>(points.cols()));
  for (Index q = 0; q < points.cols(); ++q) {
    for (Index r = 0; r < points.cols(); ++r) {
      if (r == q || (points.col(q) - points.col(r)).norm() > spacing) continue;
      found[static_cast<std::size_t>(q)].push_back(static_cast<int>(r));
    }
  }
  return found;
}

/// Calls visit(cell, positions of its lattice in L, their farthest distance).
template <int dim, class Visit>
void visit_lattices(const elasticity::Discretization<dim>& discretization,
                    int subdivisions, const Visit& visit) {
  const auto geometry = elasticity::tabulate_geometry<dim>(
      discretization.shape, discretization.mapping_degree(),
      elasticity::lattice<dim>(discretization.shape, subdivisions));
  for (int c = 0; c < discretization.cells(); ++c) {
    Eigen::Matrix3Xd at(3, geometry.values.rows());
    if (dim == 2) at.row(2).setConstant(discretization.mid_plane_z);
    at.template topRows<dim>() =
        discretization.cell_points[static_cast<std::size_t>(c)] *
        geometry.values.transpose();
    visit(c, at, (at.rowwise().maxCoeff() - at.rowwise().minCoeff()).norm());
  }
}

}  // namespace

template <int dim>
Eigen::MatrixXi zone_of_points(
    const elasticity::Discretization<dim>& discretization, int subdivisions,
    const std::vector<SingularZone>& zones) {
  Eigen::MatrixXi zone_of = Eigen::MatrixXi::Constant(
      elasticity::lattice<dim>(discretization.shape, subdivisions).cols(),
      discretization.cells(), -1);
  visit_lattices<dim>(discretization, subdivisions,
                      [&](int c, const Eigen::Matrix3Xd& at, double size) {
                        for (std::size_t z = zones.size(); z-- > 0;) {
                          const double radius = zones[z].radius;
                          if (distance(zones[z], at.col(0)) > radius + size)
                            continue;
                          for (Index q = 0; q < at.cols(); ++q) {
                            if (distance(zones[z], at.col(q)) > radius)
                              continue;
                            zone_of(q, c) = static_cast<int>(z);
                          }
                        }
                      });
  return zone_of;
}

template <int dim>
std::vector<PointBeside> points_beside(
    const elasticity::Discretization<dim>& discretization, int subdivisions,
    const std::vector<SingularZone>& zones) {
  const auto next = neighbours<dim>(discretization.shape, subdivisions);
  std::vector<PointBeside> found;
  const auto add = [&](int c, const Eigen::Matrix3Xd& at, std::size_t z) {
    const SingularZone& zone = zones[z];
    // A logarithm's is not steeper than a crack's.
    const double steepest = zone.exponent < 1.0 ? 1.0 - zone.exponent : 0.5;
    Eigen::VectorXd away(at.cols());
    for (Index q = 0; q < at.cols(); ++q) {
      away[q] = distance(zone, at.col(q)) / zone.radius;
    }
    for (int q = 0; q < at.cols(); ++q) {
      if (away[q] <= 1.0) continue;
      for (const int inside : next[static_cast<std::size_t>(q)]) {
        if (away[inside] > 1.0) continue;
        found.push_back({{c, q},
                         inside,
                         static_cast<int>(z),
                         away[q],
                         away[inside],
                         std::pow(away[q], steepest)});
      }
    }
  };
  visit_lattices<dim>(
      discretization, subdivisions,
      [&](int c, const Eigen::Matrix3Xd& at, double size) {
        for (std::size_t z = 0; z < zones.size(); ++z) {
          const double radius = zones[z].radius;
          if (radius > 0.0 && distance(zones[z], at.col(0)) <= radius + size) {
            add(c, at, z);
          }
        }
      });
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
