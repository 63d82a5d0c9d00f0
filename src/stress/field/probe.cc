#include "stress/field/probe.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include "part/part_definition.h"
#include "stress/field/cell_field.h"
#include "stress/field/stress_history.h"

namespace clevis::stress {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr double kOutside = 1e-6;  // of a cell

template <int dim>
using Point = Eigen::Matrix<double, dim, 1>;

template <int dim>
bool in_bounds(const Eigen::Matrix<double, dim, Eigen::Dynamic>& points,
               const Point<dim>& x) {
  const Point<dim> low = points.rowwise().minCoeff();
  const Point<dim> high = points.rowwise().maxCoeff();
  // A curved face may bulge beyond its geometry points a little.
  const double margin = 0.1 * (high - low).norm();
  return ((x - low).array() > -margin).all() &&
         ((high - x).array() > -margin).all();
}

template <int dim>
bool in_reference_cell(mesh::CellShape shape, const Point<dim>& xi,
                       double outside) {
  const bool low = (xi.array() >= -outside).all();
  if (shape == mesh::CellShape::kSimplex) {
    return low && xi.sum() <= 1.0 + outside;
  }
  return low && (xi.array() <= 1.0 + outside).all();
}

template <int dim>
double size_of(const Eigen::Matrix<double, dim, Eigen::Dynamic>& points) {
  return (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();
}

/// Round-off of a position so far from the origin [m].
template <int dim>
double round_off(const Point<dim>& x) {
  return 8.0 * std::numeric_limits<double>::epsilon() * x.norm();
}

/// Reference coordinates of x in a cell; false if Newton does not find any.
template <int dim>
bool invert(const elasticity::Discretization<dim>& discretization,
            std::size_t cell, const Point<dim>& x, Point<dim>& xi) {
  constexpr int kIterations = 20;
  const auto& points = discretization.cell_points[cell];
  const double close = 1e-12 * size_of<dim>(points) + round_off<dim>(x);
  xi.setConstant(discretization.shape == mesh::CellShape::kSimplex ? 0.25
                                                                   : 0.5);
  for (int k = 0; k < kIterations; ++k) {
    const elasticity::ReferencePoints<dim> here = xi;
    const auto at = elasticity::cell_geometry<dim>(
        points,
        elasticity::CellInterpolation<dim>(
            discretization.shape, discretization.mapping_degree(), here));
    const Point<dim> gap = x - at.points.col(0);
    if (gap.norm() <= close) return true;
    xi += at.inverse_jacobian[0] * gap;
    if (!(xi.norm() < 10.0)) return false;
  }
  return false;
}

/// The nearest reference coordinates in the cell, or nearly so.
template <int dim>
Point<dim> pulled_in(mesh::CellShape shape, const Point<dim>& xi) {
  const Point<dim> low = xi.cwiseMax(0.0);
  if (shape != mesh::CellShape::kSimplex) return low.cwiseMin(1.0);
  return low / std::max(1.0, low.sum());
}

/// The cell whose surface is next to a point that none holds.
template <int dim>
Location<dim> next_to(const elasticity::Discretization<dim>& discretization,
                      const Point<dim>& x, double bulge) {
  Location<dim> nearest;
  double least = bulge;
  for (std::size_t c = 0; c < discretization.cell_points.size(); ++c) {
    Point<dim> xi;
    const auto& points = discretization.cell_points[c];
    if (!in_bounds<dim>(points, x) || !invert<dim>(discretization, c, x, xi)) {
      continue;
    }
    const elasticity::ReferencePoints<dim> inside =
        pulled_in<dim>(discretization.shape, xi);
    const auto there = elasticity::cell_geometry<dim>(
        points,
        elasticity::CellInterpolation<dim>(
            discretization.shape, discretization.mapping_degree(), inside));
    const double off = (there.points.col(0) - x).norm() / size_of<dim>(points);
    if (off > least) continue;
    least = off;
    nearest = {{static_cast<int>(c), inside}};
  }
  return nearest;
}

/// Index of a quantity "stress_xy" among xx, yy, zz, xy, yz, xz.
Index stress_component(const std::string& quantity) {
  constexpr std::array<const char*, 6> kNames = {"stress_xx", "stress_yy",
                                                 "stress_zz", "stress_xy",
                                                 "stress_yz", "stress_xz"};
  for (std::size_t k = 0; k < kNames.size(); ++k) {
    if (quantity == kNames[k]) return static_cast<Index>(k);
  }
  assert(false && "the scene reader admits known quantities only");
  return 0;
}

double take(const std::string& quantity, const MatrixXd& stress,
            const Eigen::Vector3d& displacement) {
  if (quantity == "von_mises") return von_mises(stress)[0];
  if (part::is_displacement(quantity)) {
    return displacement[quantity.back() - 'x'];
  }
  return stress(0, stress_component(quantity));
}

}  // namespace

template <int dim>
Location<dim> locate(const elasticity::Discretization<dim>& discretization,
                     const Eigen::Vector3d& at, double bulge) {
  Location<dim> location;
  if (dim == 2 && std::abs(at.z() - discretization.mid_plane_z) >
                      (0.5 + kOutside) * discretization.thickness) {
    return location;
  }
  const Point<dim> x = at.head<dim>();
  for (std::size_t c = 0; c < discretization.cell_points.size(); ++c) {
    Point<dim> xi;
    const auto& points = discretization.cell_points[c];
    const double outside =
        kOutside + 8.0 * round_off<dim>(x) / size_of<dim>(points);
    if (!in_bounds<dim>(points, x) || !invert<dim>(discretization, c, x, xi) ||
        !in_reference_cell<dim>(discretization.shape, xi, outside)) {
      continue;
    }
    location.emplace_back(static_cast<int>(c), xi);
  }
  if (location.empty()) return next_to<dim>(discretization, x, bulge);
  return location;
}

template <int dim>
PointValue probe(const elasticity::DisplacementBasis<dim>& basis,
                 const part::Material& material, const Location<dim>& location,
                 const std::string& quantity, int instant) {
  assert(!location.empty());
  const MatrixXd u = basis.columns * basis.coefficients.col(instant);
  double sum = 0.0;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const auto& [cell, xi] : location) {
    const elasticity::ReferencePoints<dim> point = xi;
    const CellField<dim> field(basis.discretization, material, point);
    const auto c = static_cast<std::size_t>(cell);
    const MatrixXd values = field.stress(c, u);
    MatrixXd stress = MatrixXd::Zero(1, 6);
    for (int k = 0; k < kStressComponents<dim>; ++k) {
      stress(0, dim == 2 && k == 2 ? 3 : k) = values(k, 0);
    }
    Eigen::Vector3d displacement = Eigen::Vector3d::Zero();
    displacement.head<dim>() = field.displacement(c, u).row(0);
    const double value = take(quantity, stress, displacement);
    sum += value;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  return {sum / static_cast<double>(location.size()), high - low};
}

#define CLEVIS_INSTANTIATE(dim)                                               \
  template Location<dim> locate<dim>(const elasticity::Discretization<dim>&,  \
                                     const Eigen::Vector3d&, double);         \
  template PointValue probe<dim>(const elasticity::DisplacementBasis<dim>&,   \
                                 const part::Material&, const Location<dim>&, \
                                 const std::string&, int);
CLEVIS_INSTANTIATE(2)
CLEVIS_INSTANTIATE(3)
#undef CLEVIS_INSTANTIATE

}  // namespace clevis::stress
