#include "elasticity/dealii/stiffness_operator.h"

#include <algorithm>
#include <cmath>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/matrix_free/fe_evaluation.h>

namespace clevis::elasticity {
namespace {

using dealii::EvaluationFlags::gradients;

/// Degree and quadrature are known at run time; deal.II finds its compiled
/// kernel by them.
template <int dim, typename Number>
using Evaluation = dealii::FEEvaluation<dim, -1, 0, dim, Number>;

/// From the displacements of a batch of cells to their nodal forces.
template <int dim, typename Number>
void apply_law(Evaluation<dim, Number>& cell, Number lambda, Number two_mu) {
  cell.evaluate(gradients);
  for (unsigned q = 0; q < cell.n_q_points; ++q) {
    auto stress = cell.get_symmetric_gradient(q);
    const auto pressure = dealii::trace(stress) * lambda;
    stress *= dealii::make_vectorized_array<Number>(two_mu);
    for (unsigned d = 0; d < dim; ++d) stress[d][d] += pressure;
    cell.submit_symmetric_gradient(stress, q);
  }
  cell.integrate(gradients);
}

}  // namespace

template <int dim, typename Number>
void StiffnessOperator<dim, Number>::reinit(const DegreeSpace<dim>& space,
                                            int points,
                                            const CellStiffness& stiffness,
                                            const std::vector<BedFace>& beds) {
  lambda_ = static_cast<Number>(stiffness.lambda);
  two_mu_ = static_cast<Number>(2.0 * stiffness.mu);
  held_.copy_from(space.held());
  typename Cells::AdditionalData data;
  data.tasks_parallel_scheme = Cells::AdditionalData::none;
  data.mapping_update_flags =
      dealii::update_gradients | dealii::update_JxW_values;
  cells_.reinit(space.share().mapping(), space.handler(), held_,
                dealii::QGauss<1>(static_cast<unsigned>(points)), data);
  held_rows_ = cells_.get_constrained_dofs();
  beds_.clear();
  has_beds_ = !beds.empty();
  for (const BedFace& face : beds) take_bed(space, face);
}

/// The bed's stiffness on the functions of this degree that do not vanish on
/// the face: that on the nodes, between their values there.
template <int dim, typename Number>
void StiffnessOperator<dim, Number>::take_bed(const DegreeSpace<dim>& space,
                                              const BedFace& face) {
  const auto& element = space.handler().get_fe();
  const auto& partitioner = *cells_.get_vector_partitioner();
  for (const auto& cell : space.handler().active_cell_iterators()) {
    if (!cell->is_locally_owned() ||
        MeshShare<dim>::number(cell) != face.cell) {
      continue;
    }
    Numbers numbers(element.n_dofs_per_cell());
    cell->get_dof_indices(numbers);
    Bed bed;
    std::vector<unsigned> functions;
    for (unsigned i = 0; i < numbers.size(); ++i) {
      const auto function = element.system_to_component_index(i).second;
      double largest = 0.0;
      for (const int n : face.nodes) {
        largest = std::max(largest, std::abs(space.at_nodes()[n][function]));
      }
      if (largest < 1e-9 || space.held().is_constrained(numbers[i])) continue;
      functions.push_back(i);
      bed.numbers.push_back(numbers[i]);
      bed.rows.push_back(partitioner.global_to_local(numbers[i]));
    }
    dealii::FullMatrix<double> values(face.matrix.m(), functions.size());
    for (unsigned n = 0; n < face.nodes.size(); ++n) {
      for (unsigned j = 0; j < functions.size(); ++j) {
        const auto [component, function] =
            element.system_to_component_index(functions[j]);
        values(dim * n + component, j) =
            space.at_nodes()[face.nodes[n]][function];
      }
    }
    bed.matrix.reinit(functions.size(), functions.size());
    bed.matrix.triple_product(face.matrix, values, values, true, false);
    beds_.push_back(std::move(bed));
    return;
  }
}

template <int dim, typename Number>
void StiffnessOperator<dim, Number>::initialize_dof_vector(
    Vector& vector) const {
  cells_.initialize_dof_vector(vector);
}

template <int dim, typename Number>
dealii::types::global_dof_index StiffnessOperator<dim, Number>::m() const {
  return cells_.get_dof_handler().n_dofs();
}

template <int dim, typename Number>
void StiffnessOperator<dim, Number>::apply_cells(const Cells& cells, Vector& y,
                                                 const Vector& x,
                                                 const Range& range) const {
  Evaluation<dim, Number> cell(cells);
  for (unsigned c = range.first; c < range.second; ++c) {
    cell.reinit(c);
    cell.read_dof_values(x);
    apply_law<dim, Number>(cell, lambda_, two_mu_);
    cell.distribute_local_to_global(y);
  }
}

template <int dim, typename Number>
void StiffnessOperator<dim, Number>::apply_beds(Vector& y,
                                                const Vector& x) const {
  x.update_ghost_values();
  for (const Bed& bed : beds_) {
    for (unsigned i = 0; i < bed.rows.size(); ++i) {
      double force = 0.0;
      for (unsigned j = 0; j < bed.rows.size(); ++j) {
        force += bed.matrix(i, j) * double(x.local_element(bed.rows[j]));
      }
      y.local_element(bed.rows[i]) += static_cast<Number>(force);
    }
  }
  y.compress(dealii::VectorOperation::add);
  x.zero_out_ghost_values();
}

template <int dim, typename Number>
void StiffnessOperator<dim, Number>::vmult(Vector& y, const Vector& x) const {
  cells_.cell_loop(&StiffnessOperator::apply_cells, this, y, x, true);
  if (has_beds_) apply_beds(y, x);
  for (const unsigned row : held_rows_) {
    y.local_element(row) = x.local_element(row);
  }
}

template <int dim, typename Number>
typename StiffnessOperator<dim, Number>::Vector
StiffnessOperator<dim, Number>::diagonal() const {
  Vector result;
  initialize_dof_vector(result);
  Evaluation<dim, Number> cell(cells_);
  dealii::AlignedVector<dealii::VectorizedArray<Number>> entries(
      cell.dofs_per_cell);
  for (unsigned c = 0; c < cells_.n_cell_batches(); ++c) {
    cell.reinit(c);
    for (unsigned i = 0; i < cell.dofs_per_cell; ++i) {
      for (unsigned j = 0; j < cell.dofs_per_cell; ++j) {
        cell.begin_dof_values()[j] = Number(i == j ? 1 : 0);
      }
      apply_law<dim, Number>(cell, lambda_, two_mu_);
      entries[i] = cell.begin_dof_values()[i];
    }
    for (unsigned i = 0; i < cell.dofs_per_cell; ++i) {
      cell.begin_dof_values()[i] = entries[i];
    }
    cell.distribute_local_to_global(result);
  }
  for (const Bed& bed : beds_) {
    for (unsigned i = 0; i < bed.rows.size(); ++i) {
      result.local_element(bed.rows[i]) +=
          static_cast<Number>(bed.matrix(i, i));
    }
  }
  result.compress(dealii::VectorOperation::add);
  for (const unsigned row : held_rows_) result.local_element(row) = Number(1);
  return result;
}

template <int dim, typename Number>
void StiffnessOperator<dim, Number>::visit_cells(
    const std::function<void(const Entries&, const Numbers&)>& visit) const {
  Evaluation<dim, Number> cell(cells_);
  const auto& lexicographic = cells_.get_shape_info().lexicographic_numbering;
  const unsigned n = cell.dofs_per_cell;
  Numbers dofs(n);
  for (unsigned c = 0; c < cells_.n_cell_batches(); ++c) {
    const unsigned filled = cells_.n_active_entries_per_cell_batch(c);
    std::vector<Entries> matrices(filled, Entries(n, n));
    cell.reinit(c);
    for (unsigned j = 0; j < n; ++j) {
      for (unsigned i = 0; i < n; ++i) {
        cell.begin_dof_values()[i] = Number(i == j ? 1 : 0);
      }
      apply_law<dim, Number>(cell, lambda_, two_mu_);
      for (unsigned i = 0; i < n; ++i) {
        for (unsigned lane = 0; lane < filled; ++lane) {
          matrices[lane](lexicographic[i], lexicographic[j]) =
              cell.begin_dof_values()[i][lane];
        }
      }
    }
    for (unsigned lane = 0; lane < filled; ++lane) {
      cells_.get_cell_iterator(c, lane)->get_dof_indices(dofs);
      visit(matrices[lane], dofs);
    }
  }
  for (const Bed& bed : beds_) visit(bed.matrix, bed.numbers);
}

template class StiffnessOperator<2, double>;
template class StiffnessOperator<2, float>;
template class StiffnessOperator<3, double>;
template class StiffnessOperator<3, float>;

}  // namespace clevis::elasticity
