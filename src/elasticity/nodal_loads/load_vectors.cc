#include "elasticity/nodal_loads/load_vectors.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "elasticity/algebra/dense_product.h"
#include "elasticity/nodal_loads/surface_loads.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;

/// ∫ N dV and ∫ N p dV per node: nodes × 4 (1, x, y, z), z the mid-plane's.
template <int dim>
MatrixXd node_moments(const Discretization<dim>& discretization) {
  // Of simplices the rule counts the total degree, det J's included.
  const int more = discretization.shape == mesh::CellShape::kTensor
                       ? 2
                       : 1 + discretization.geometry_degree;
  const Degree points = {discretization.degree + more,
                         discretization.thickness_degree + more};
  const auto rule = gauss<dim>(discretization.shape, points);
  const auto displacement = tabulate_displacement<dim>(
      discretization.shape, discretization.displacement_degree(), rule.points);
  const CellInterpolation<dim> geometry(
      discretization.shape, discretization.mapping_degree(), rule.points);
  MatrixXd moments = MatrixXd::Zero(discretization.nodes, 4);
  MatrixXd factor(rule.weights.size(), 4);
  factor.col(3).setConstant(discretization.mid_plane_z);
  for (std::size_t c = 0; c < discretization.cell_nodes.size(); ++c) {
    const auto at = cell_geometry<dim>(discretization.cell_points[c], geometry);
    const Eigen::VectorXd weights =
        rule.weights.cwiseProduct(at.determinant) * discretization.thickness;
    factor.col(0).setOnes();
    factor.middleCols<dim>(1) = at.points.transpose();
    const MatrixXd cell =
        transposed_product(displacement.values, weights.asDiagonal() * factor);
    const auto& nodes = discretization.cell_nodes[c];
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      moments.row(nodes[i]) += cell.row(static_cast<Index>(i));
    }
  }
  return moments;
}

/// Columns that span the columns of `values`, orthonormal, by pivoted
/// Gram-Schmidt: the column with the largest rest is next, until no rest is
/// above the tolerance.
/// @param tolerance  of the rest, over the largest column [1].
MatrixXd spanning_columns(const MatrixXd& values, double tolerance) {
  MatrixXd rest = values;
  Eigen::VectorXd norms = rest.colwise().squaredNorm();
  const double enough = tolerance * tolerance * norms.maxCoeff();
  std::vector<Eigen::VectorXd> columns;
  Index next = 0;
  while (norms.maxCoeff(&next) > enough) {
    Eigen::VectorXd q = rest.col(next);
    for (const auto& other : columns) q -= other.dot(q) * other;
    q.normalize();
    // Rests that are small enough only fall, and need no more looking after.
    for (Index i = 0; i < rest.cols(); ++i) {
      if (norms[i] <= enough) continue;
      auto column = rest.col(i);
      column -= q.dot(column) * q;
      norms[i] = column.squaredNorm();
    }
    norms[next] = 0.0;
    columns.push_back(std::move(q));
  }
  MatrixXd result(values.rows(), static_cast<Index>(columns.size()));
  for (std::size_t k = 0; k < columns.size(); ++k) {
    result.col(static_cast<Index>(k)) = columns[k];
  }
  return result;
}

/// Columns at some of the rows, and what goes with them by instant.
struct SurfaceColumns {
  std::vector<Index> rows;  ///< of the part
  MatrixXd columns, coefficients;
};

template <int dim>
SurfaceColumns surface_columns(const SurfaceLoads& surface) {
  constexpr double kTolerance = 1e-9;  // far below that of the load basis
  SurfaceColumns found;
  if (!(surface.values.cwiseAbs().maxCoeff() > 0.0)) return found;
  for (const int node : surface.nodes) {
    for (int k = 0; k < dim; ++k) found.rows.push_back(dim * Index{node} + k);
  }
  found.columns = spanning_columns(surface.values, kTolerance);
  found.coefficients = transposed_product(found.columns, surface.values);
  return found;
}

/// Of all surfaces, over the rows of any of them.
SplitLoads joined(const std::vector<SurfaceColumns>& surfaces, Index dofs,
                  Index instants) {
  std::vector<Index> rows;
  Index count = 0;
  for (const SurfaceColumns& surface : surfaces) {
    rows.insert(rows.end(), surface.rows.begin(), surface.rows.end());
    count += surface.columns.cols();
  }
  std::ranges::sort(rows);
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  MatrixXd columns = MatrixXd::Zero(std::ssize(rows), count);
  MatrixXd coefficients(count, instants);
  Index at = 0;
  for (const SurfaceColumns& surface : surfaces) {
    const Index n = surface.columns.cols();
    if (n == 0) continue;
    for (std::size_t k = 0; k < surface.rows.size(); ++k) {
      const auto row = std::ranges::lower_bound(rows, surface.rows[k]);
      columns.row(row - rows.begin()).segment(at, n) =
          surface.columns.row(static_cast<Index>(k));
    }
    coefficients.middleRows(at, n) = surface.coefficients;
    at += n;
  }
  return {{std::move(rows), std::move(columns), MatrixXd(dofs, 0)},
          std::move(coefficients)};
}

void append(const MatrixXd& columns, const MatrixXd& coefficients,
            SplitLoads& loads) {
  const Index before = loads.columns.cols(), more = columns.cols();
  loads.columns.append(columns);
  loads.coefficients.conservativeResize(before + more, Eigen::NoChange);
  loads.coefficients.bottomRows(more) = coefficients;
}

/// −ρ (a + α×p + ω×(ω×p)) is linear in p: a column per power of p and
/// component that occurs.
template <int dim>
void append_body(const Discretization<dim>& discretization,
                 const loads::LoadHistory& history, double density,
                 SplitLoads& loads) {
  const auto instants = static_cast<Index>(history.instants.size());
  MatrixXd field(4 * dim, instants);  // acceleration = Σ_j field(j, a) p_j
  for (Index i = 0; i < instants; ++i) {
    const auto& rigid = history.instants[static_cast<std::size_t>(i)].rigid;
    field.col(i).head<dim>() = rigid.acceleration.head<dim>();
    for (int k = 0; k < 3; ++k) {
      const Vector3d e = Vector3d::Unit(k);
      const Vector3d slope =
          rigid.alpha.cross(e) + rigid.omega.cross(rigid.omega.cross(e));
      field.col(i).segment<dim>(dim * (1 + k)) = slope.head<dim>();
    }
  }
  if (field.isZero(0.0)) return;
  const MatrixXd moments = node_moments(discretization);
  std::vector<Index> acting;
  for (Index row = 0; row < field.rows(); ++row) {
    if (!field.row(row).isZero(0.0)) acting.push_back(row);
  }
  MatrixXd columns = MatrixXd::Zero(discretization.dofs(), std::ssize(acting));
  for (std::size_t k = 0; k < acting.size(); ++k) {
    const Index row = acting[k];
    for (Index node = 0; node < moments.rows(); ++node) {
      columns(dim * node + row % dim, static_cast<Index>(k)) =
          -density * moments(node, row / dim);
    }
  }
  append(columns, field(acting, Eigen::all), loads);
}

/// Consistent mass times rigid motions (translations, rotations about Lo):
/// dofs × modes [kg], [kg m].
template <int dim>
MatrixXd rigid_inertia(const MatrixXd& moments, double density) {
  MatrixXd inertia = MatrixXd::Zero(dim * moments.rows(), dim == 2 ? 3 : 6);
  for (Index node = 0; node < moments.rows(); ++node) {
    auto at = inertia.middleRows<dim>(dim * node);
    at.template leftCols<dim>().diagonal().setConstant(moments(node, 0));
    const Vector3d arm = moments.row(node).tail<3>();
    if constexpr (dim == 2) {
      at.col(2) << -arm.y(), arm.x();
    } else {
      for (int k = 0; k < 3; ++k) at.col(3 + k) = Vector3d::Unit(k).cross(arm);
    }
  }
  inertia *= density;
  return inertia;
}

/// Whether loads cancel node by node but for round-off, as of a joint that
/// takes up at once what another brings: they stress nothing.
bool cancel(const SplitLoads& loads) {
  constexpr double kRoundOff = 1e-11;
  if (loads.columns.cols() < 2) return false;
  const double gross = loads.columns.magnitudes().dot(
      loads.coefficients.cwiseAbs().rowwise().maxCoeff());
  return loads.columns.largest_column_sum(loads.coefficients) <=
         kRoundOff * gross;
}

/// Leaves out the columns that hardly count beside the largest.
void drop_small_columns(double scale, SplitLoads& loads) {
  constexpr double kNothing = 1e-13;
  const Eigen::VectorXd sizes = loads.columns.magnitudes().cwiseProduct(
      loads.coefficients.cwiseAbs().rowwise().maxCoeff());
  std::vector<Index> kept;
  for (Index k = 0; k < sizes.size(); ++k) {
    if (sizes[k] > kNothing * scale) kept.push_back(k);
  }
  loads.columns.keep(kept);
  loads.coefficients = loads.coefficients(kept, Eigen::all).eval();
}

}  // namespace

template <int dim>
Eigen::VectorXd node_volumes(const Discretization<dim>& discretization) {
  return node_moments(discretization).col(0);
}

template <int dim>
SplitLoads load_columns(const Discretization<dim>& discretization,
                        const loads::LoadHistory& history, double density,
                        const std::string& part_name) {
  return load_columns<dim>(discretization, history, density,
                           surface_loads(discretization, history, part_name));
}

template <int dim>
SplitLoads load_columns(const Discretization<dim>& discretization,
                        const loads::LoadHistory& history, double density,
                        const std::vector<SurfaceLoads>& surfaces) {
  const Index dofs = discretization.dofs();
  const auto instants = static_cast<Index>(history.instants.size());
  std::vector<SurfaceColumns> columns;
  for (const SurfaceLoads& surface : surfaces) {
    columns.push_back(surface_columns<dim>(surface));
  }
  SplitLoads loads = joined(columns, dofs, instants);
  append_body<dim>(discretization, history, density, loads);
  if (cancel(loads)) return {SplitColumns(dofs), MatrixXd(0, instants)};
  return loads;
}

template <int dim>
MatrixXd assemble_loads(const Discretization<dim>& discretization,
                        const loads::LoadHistory& history, double density,
                        const std::string& part_name) {
  const auto instants = static_cast<Index>(history.instants.size());
  SplitLoads body{SplitColumns(discretization.dofs()), MatrixXd(0, instants)};
  append_body<dim>(discretization, history, density, body);
  MatrixXd result = body.columns.times(body.coefficients);
  for (const SurfaceLoads& surface :
       surface_loads(discretization, history, part_name)) {
    for (std::size_t k = 0; k < surface.nodes.size(); ++k) {
      result.middleRows<dim>(dim * surface.nodes[k]) +=
          surface.values.middleRows<dim>(dim * static_cast<Index>(k));
    }
  }
  return result;
}

template <int dim>
LoadBalance balance_loads(const Discretization<dim>& discretization,
                          double density, const MatrixXd& modes,
                          SplitLoads& loads) {
  LoadBalance balance;
  const double scale = loads.columns.largest_column_sum(loads.coefficients);
  if (!(scale > 0.0)) return balance;
  const MatrixXd residual = loads.columns.transposed_times(modes);
  const MatrixXd inertia =
      rigid_inertia<dim>(node_moments(discretization), density);
  const MatrixXd acceleration =
      transposed_product(modes, inertia).fullPivLu().solve(residual);
  balance.relief =
      product(residual, loads.coefficients).cwiseAbs().maxCoeff() / scale;
  append(inertia, -product(acceleration, loads.coefficients), loads);
  drop_small_columns(scale, loads);
  if (loads.columns.cols() == 0) return balance;
  balance.rest =
      product(loads.columns.transposed_times(modes), loads.coefficients)
          .cwiseAbs()
          .maxCoeff() /
      scale;
  return balance;
}

template <int dim>
double balance_loads(const Discretization<dim>& discretization, double density,
                     const MatrixXd& modes, MatrixXd& history) {
  const double scale = history.cwiseAbs().colwise().sum().maxCoeff();
  if (!(scale > 0.0)) return 0.0;
  const MatrixXd residual = transposed_product(modes, history);
  const MatrixXd inertia =
      rigid_inertia<dim>(node_moments(discretization), density);
  history -= product(
      inertia, transposed_product(modes, inertia).fullPivLu().solve(residual));
  return residual.cwiseAbs().maxCoeff() / scale;
}

#define CLEVIS_INSTANTIATE(dim)                                               \
  template Eigen::VectorXd node_volumes<dim>(const Discretization<dim>&);     \
  template SplitLoads load_columns<dim>(const Discretization<dim>&,           \
                                        const loads::LoadHistory&, double,    \
                                        const std::string&);                  \
  template SplitLoads load_columns<dim>(const Discretization<dim>&,           \
                                        const loads::LoadHistory&, double,    \
                                        const std::vector<SurfaceLoads>&);    \
  template MatrixXd assemble_loads<dim>(const Discretization<dim>&,           \
                                        const loads::LoadHistory&, double,    \
                                        const std::string&);                  \
  template LoadBalance balance_loads<dim>(const Discretization<dim>&, double, \
                                          const MatrixXd&, SplitLoads&);      \
  template double balance_loads<dim>(const Discretization<dim>&, double,      \
                                     const MatrixXd&, MatrixXd&);
CLEVIS_INSTANTIATE(2)
CLEVIS_INSTANTIATE(3)
#undef CLEVIS_INSTANTIATE

}  // namespace clevis::elasticity
