#pragma once

// StiffnessOperator, for the sources that compile it with the lanes of an
// instruction set.
#include <algorithm>
#include <cmath>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/matrix_free/fe_evaluation.h>
#include <deal.II/matrix_free/matrix_free.h>
#if DEAL_II_VECTORIZATION_WIDTH_IN_BITS > 0
// Debian's library holds these for one lane only.
#include <deal.II/matrix_free/evaluation_template_factory.templates.h>
#include <deal.II/matrix_free/evaluation_template_factory_hanging_nodes.templates.h>
#include <deal.II/matrix_free/mapping_info.templates.h>
#include <deal.II/matrix_free/mapping_info_storage.templates.h>
#include <deal.II/matrix_free/matrix_free.templates.h>
#include <deal.II/matrix_free/shape_info.templates.h>
// The header of faces has the same include guard as that of cells.
#undef dealii_matrix_free_evaluation_template_factory_templates_h
#include <deal.II/matrix_free/evaluation_template_face_factory.templates.h>
#endif

#include "elasticity/dealii_levels/stiffness_operator.h"

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
struct StiffnessOperator<dim, Number>::Lanes {
  struct Bed {
    std::vector<unsigned> rows;  ///< in the rank's vectors, ghosts behind
    Numbers numbers;             ///< over all ranks
    dealii::FullMatrix<double> matrix;  ///< [N/m]
  };
  using Range = std::pair<unsigned, unsigned>;
  using Cells = dealii::MatrixFree<dim, Number>;
  void take_bed(const DegreeSpace<dim>& space, const BedFace& face);
  void apply_cells(const Cells& from, Vector& y, const Vector& x,
                   const Range& range) const;
  void apply_beds(Vector& y, const Vector& x) const;

  Cells cells;
  dealii::AffineConstraints<Number> held;
  std::vector<unsigned> held_rows;
  std::vector<Bed> beds;  ///< under the rank's cells
  bool has_beds = false;  ///< under any rank's
  Number lambda{}, two_mu{};
};

template <int dim, typename Number>
StiffnessOperator<dim, Number>::StiffnessOperator()
    : lanes_(std::make_unique<Lanes>()) {}

template <int dim, typename Number>
StiffnessOperator<dim, Number>::~StiffnessOperator() = default;

template <int dim, typename Number>
void StiffnessOperator<dim, Number>::reinit(const DegreeSpace<dim>& space,
                                            int points,
                                            const CellStiffness& stiffness,
                                            const std::vector<BedFace>& beds) {
  Lanes& l = *lanes_;
  l.lambda = static_cast<Number>(stiffness.lambda);
  l.two_mu = static_cast<Number>(2.0 * stiffness.mu);
  l.held.copy_from(space.held());
  typename Lanes::Cells::AdditionalData data;
  data.tasks_parallel_scheme = Lanes::Cells::AdditionalData::none;
  data.mapping_update_flags =
      dealii::update_gradients | dealii::update_JxW_values;
  l.cells.reinit(space.share().mapping(), space.handler(), l.held,
                 dealii::QGauss<1>(static_cast<unsigned>(points)), data);
  l.held_rows = l.cells.get_constrained_dofs();
  l.beds.clear();
  l.has_beds = !beds.empty();
  for (const BedFace& face : beds) l.take_bed(space, face);
}

/// The bed's stiffness on the functions of this degree that do not vanish on
/// the face: that on the nodes, between their values there.
template <int dim, typename Number>
void StiffnessOperator<dim, Number>::Lanes::take_bed(
    const DegreeSpace<dim>& space, const BedFace& face) {
  const auto& element = space.handler().get_fe();
  const auto& partitioner = *cells.get_vector_partitioner();
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
    beds.push_back(std::move(bed));
    return;
  }
}

template <int dim, typename Number>
void StiffnessOperator<dim, Number>::initialize_dof_vector(
    Vector& vector) const {
  lanes_->cells.initialize_dof_vector(vector);
}

template <int dim, typename Number>
dealii::types::global_dof_index StiffnessOperator<dim, Number>::m() const {
  return lanes_->cells.get_dof_handler().n_dofs();
}

template <int dim, typename Number>
std::size_t StiffnessOperator<dim, Number>::bytes_sent() const {
  const auto& rows = *lanes_->cells.get_vector_partitioner();
  return sizeof(Number) * (rows.n_ghost_indices() + rows.n_import_indices());
}

template <int dim, typename Number>
void StiffnessOperator<dim, Number>::Lanes::apply_cells(
    const Cells& from, Vector& y, const Vector& x, const Range& range) const {
  Evaluation<dim, Number> cell(from);
  for (unsigned c = range.first; c < range.second; ++c) {
    cell.reinit(c);
    cell.read_dof_values(x);
    apply_law<dim, Number>(cell, lambda, two_mu);
    cell.distribute_local_to_global(y);
  }
}

template <int dim, typename Number>
void StiffnessOperator<dim, Number>::Lanes::apply_beds(Vector& y,
                                                       const Vector& x) const {
  x.update_ghost_values();
  for (const Bed& bed : beds) {
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
  const Lanes& l = *lanes_;
  l.cells.cell_loop(&Lanes::apply_cells, &l, y, x, true);
  if (l.has_beds) l.apply_beds(y, x);
  for (const unsigned row : l.held_rows) {
    y.local_element(row) = x.local_element(row);
  }
}

template <int dim, typename Number>
typename StiffnessOperator<dim, Number>::Vector
StiffnessOperator<dim, Number>::diagonal() const {
  const Lanes& l = *lanes_;
  Vector result;
  initialize_dof_vector(result);
  Evaluation<dim, Number> cell(l.cells);
  dealii::AlignedVector<dealii::VectorizedArray<Number>> entries(
      cell.dofs_per_cell);
  for (unsigned c = 0; c < l.cells.n_cell_batches(); ++c) {
    cell.reinit(c);
    for (unsigned i = 0; i < cell.dofs_per_cell; ++i) {
      for (unsigned j = 0; j < cell.dofs_per_cell; ++j) {
        cell.begin_dof_values()[j] = Number(i == j ? 1 : 0);
      }
      apply_law<dim, Number>(cell, l.lambda, l.two_mu);
      entries[i] = cell.begin_dof_values()[i];
    }
    for (unsigned i = 0; i < cell.dofs_per_cell; ++i) {
      cell.begin_dof_values()[i] = entries[i];
    }
    cell.distribute_local_to_global(result);
  }
  for (const auto& bed : l.beds) {
    for (unsigned i = 0; i < bed.rows.size(); ++i) {
      result.local_element(bed.rows[i]) +=
          static_cast<Number>(bed.matrix(i, i));
    }
  }
  result.compress(dealii::VectorOperation::add);
  for (const unsigned row : l.held_rows) result.local_element(row) = Number(1);
  return result;
}

template <int dim, typename Number>
void StiffnessOperator<dim, Number>::visit_cells(
    const std::function<void(const Entries&, const Numbers&)>& visit) const {
  const Lanes& l = *lanes_;
  Evaluation<dim, Number> cell(l.cells);
  const auto& lexicographic = l.cells.get_shape_info().lexicographic_numbering;
  const unsigned n = cell.dofs_per_cell;
  Numbers dofs(n);
  for (unsigned c = 0; c < l.cells.n_cell_batches(); ++c) {
    const unsigned filled = l.cells.n_active_entries_per_cell_batch(c);
    std::vector<Entries> matrices(filled, Entries(n, n));
    cell.reinit(c);
    for (unsigned j = 0; j < n; ++j) {
      for (unsigned i = 0; i < n; ++i) {
        cell.begin_dof_values()[i] = Number(i == j ? 1 : 0);
      }
      apply_law<dim, Number>(cell, l.lambda, l.two_mu);
      for (unsigned i = 0; i < n; ++i) {
        for (unsigned lane = 0; lane < filled; ++lane) {
          matrices[lane](lexicographic[i], lexicographic[j]) =
              cell.begin_dof_values()[i][lane];
        }
      }
    }
    for (unsigned lane = 0; lane < filled; ++lane) {
      l.cells.get_cell_iterator(c, lane)->get_dof_indices(dofs);
      visit(matrices[lane], dofs);
    }
  }
  for (const auto& bed : l.beds) visit(bed.matrix, bed.numbers);
}

}  // namespace clevis::elasticity
