#include "elasticity/nodal_loads/load_vectors.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "elasticity/algebra/column_split.h"
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

/// Collects columns and the coefficients that go with them.
class Columns {
 public:
  Columns(Index dofs, Index instants) : dofs_(dofs), instants_(instants) {}

  void append(MatrixXd columns, MatrixXd coefficients) {
    count_ += columns.cols();
    columns_.push_back(std::move(columns));
    coefficients_.push_back(std::move(coefficients));
  }

  LoadBasis join() const {
    LoadBasis result;
    result.columns.resize(dofs_, count_);
    result.coefficients.resize(count_, instants_);
    Index at = 0;
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      const Index n = columns_[k].cols();
      result.columns.middleCols(at, n) = columns_[k];
      result.coefficients.middleRows(at, n) = coefficients_[k];
      at += n;
    }
    return result;
  }

 private:
  Index dofs_, instants_, count_ = 0;
  std::vector<MatrixXd> columns_, coefficients_;
};

template <int dim>
void append_surface(const SurfaceLoads& surface, Index dofs, Columns& columns) {
  constexpr double kTolerance = 1e-9;  // far below that of the load basis
  if (!(surface.values.cwiseAbs().maxCoeff() > 0.0)) return;
  const MatrixXd basis = spanning_columns(surface.values, kTolerance);
  MatrixXd scattered = MatrixXd::Zero(dofs, basis.cols());
  for (std::size_t k = 0; k < surface.nodes.size(); ++k) {
    scattered.middleRows<dim>(dim * surface.nodes[k]) =
        basis.middleRows<dim>(dim * static_cast<Index>(k));
  }
  columns.append(std::move(scattered),
                 transposed_product(basis, surface.values));
}

/// −ρ (a + α×p + ω×(ω×p)) is linear in p: a column per power of p and
/// component that occurs.
template <int dim>
void append_body(const Discretization<dim>& discretization,
                 const loads::LoadHistory& history, double density,
                 Columns& columns) {
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
  for (Index row = 0; row < field.rows(); ++row) {
    if (field.row(row).isZero(0.0)) continue;
    MatrixXd column = MatrixXd::Zero(dim * moments.rows(), 1);
    for (Index node = 0; node < moments.rows(); ++node) {
      column(dim * node + row % dim) = -density * moments(node, row / dim);
    }
    columns.append(std::move(column), field.row(row));
  }
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

void append(const MatrixXd& columns, const MatrixXd& coefficients,
            LoadBasis& loads) {
  const Index before = loads.columns.cols(), more = columns.cols();
  loads.columns.conservativeResize(Eigen::NoChange, before + more);
  loads.columns.rightCols(more) = columns;
  loads.coefficients.conservativeResize(before + more, Eigen::NoChange);
  loads.coefficients.bottomRows(more) = coefficients;
}

/// Whether loads cancel node by node but for round-off, as of a joint that
/// takes up at once what another brings: they stress nothing.
bool cancel(const MatrixXd& columns, const MatrixXd& coefficients) {
  constexpr double kRoundOff = 1e-11;
  if (columns.cols() < 2) return false;
  double gross = 0.0;
  for (Index k = 0; k < columns.cols(); ++k) {
    gross += columns.col(k).cwiseAbs().sum() *
             coefficients.row(k).cwiseAbs().maxCoeff();
  }
  return ColumnSplit(columns).largest_column_sum(coefficients) <=
         kRoundOff * gross;
}

/// Leaves out the columns that hardly count beside the largest.
void drop_small_columns(double scale, LoadBasis& loads) {
  constexpr double kNothing = 1e-13;
  Index kept = 0;
  for (Index k = 0; k < loads.columns.cols(); ++k) {
    const double size = loads.columns.col(k).cwiseAbs().sum() *
                        loads.coefficients.row(k).cwiseAbs().maxCoeff();
    if (size <= kNothing * scale) continue;
    loads.columns.col(kept) = loads.columns.col(k);
    loads.coefficients.row(kept) = loads.coefficients.row(k);
    ++kept;
  }
  loads.columns.conservativeResize(Eigen::NoChange, kept);
  loads.coefficients.conservativeResize(kept, Eigen::NoChange);
}

}  // namespace

template <int dim>
Eigen::VectorXd node_volumes(const Discretization<dim>& discretization) {
  return node_moments(discretization).col(0);
}

template <int dim>
LoadBasis load_columns(const Discretization<dim>& discretization,
                       const loads::LoadHistory& history, double density,
                       const std::string& part_name) {
  const Index dofs = discretization.dofs();
  Columns columns(dofs, static_cast<Index>(history.instants.size()));
  for (const SurfaceLoads& surface :
       surface_loads(discretization, history, part_name)) {
    append_surface<dim>(surface, dofs, columns);
  }
  append_body<dim>(discretization, history, density, columns);
  LoadBasis loads = columns.join();
  if (cancel(loads.columns, loads.coefficients)) {
    loads.columns.resize(dofs, 0);
    loads.coefficients.resize(0, loads.coefficients.cols());
  }
  return loads;
}

template <int dim>
MatrixXd assemble_loads(const Discretization<dim>& discretization,
                        const loads::LoadHistory& history, double density,
                        const std::string& part_name) {
  const auto instants = static_cast<Index>(history.instants.size());
  Columns columns(discretization.dofs(), instants);
  append_body<dim>(discretization, history, density, columns);
  const LoadBasis body = columns.join();
  MatrixXd result = product(body.columns, body.coefficients);
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
                          LoadBasis& loads) {
  LoadBalance balance;
  const double scale =
      ColumnSplit(loads.columns).largest_column_sum(loads.coefficients);
  if (!(scale > 0.0)) return balance;
  const MatrixXd residual = transposed_product(modes, loads.columns);
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
      product(transposed_product(modes, loads.columns), loads.coefficients)
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
  template LoadBasis load_columns<dim>(const Discretization<dim>&,            \
                                       const loads::LoadHistory&, double,     \
                                       const std::string&);                   \
  template MatrixXd assemble_loads<dim>(const Discretization<dim>&,           \
                                        const loads::LoadHistory&, double,    \
                                        const std::string&);                  \
  template LoadBalance balance_loads<dim>(const Discretization<dim>&, double, \
                                          const MatrixXd&, LoadBasis&);       \
  template double balance_loads<dim>(const Discretization<dim>&, double,      \
                                     const MatrixXd&, MatrixXd&);
CLEVIS_INSTANTIATE(2)
CLEVIS_INSTANTIATE(3)
#undef CLEVIS_INSTANTIATE

}  // namespace clevis::elasticity
