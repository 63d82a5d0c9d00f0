#include "elasticity/dealii_space/degree_space.h"

#include <cmath>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>

#include "base/messages/errors.h"

namespace clevis::elasticity {
namespace {

using dealii::types::global_dof_index;

template <int dim>
std::vector<std::vector<double>> values_at_nodes(int degree, int fine_degree) {
  const dealii::FE_Q<dim> coarse(static_cast<unsigned>(degree));
  const dealii::FE_Q<dim> fine(static_cast<unsigned>(fine_degree));
  std::vector<std::vector<double>> values;
  for (const auto& node : fine.get_unit_support_points()) {
    auto& row = values.emplace_back();
    for (unsigned i = 0; i < coarse.n_dofs_per_cell(); ++i) {
      row.push_back(coarse.shape_value(i, node));
    }
  }
  return values;
}

/// Whether each of a cell's scalar functions is not zero at a held node, per
/// component.
template <int dim>
std::vector<std::vector<bool>> held_functions(
    const std::vector<std::vector<double>>& at_nodes,
    const std::vector<char>& is_held) {
  constexpr double kZero = 1e-9;
  std::vector<std::vector<bool>> result(
      dim, std::vector<bool>(at_nodes.front().size(), false));
  for (std::size_t n = 0; n < at_nodes.size(); ++n) {
    for (std::size_t a = 0; a < dim; ++a) {
      if (is_held[dim * n + a] == 0) continue;
      for (std::size_t i = 0; i < at_nodes[n].size(); ++i) {
        if (std::abs(at_nodes[n][i]) > kZero) result[a][i] = true;
      }
    }
  }
  return result;
}

}  // namespace

template <int dim>
DegreeSpace<dim>::DegreeSpace(const MeshShare<dim>& share, int degree)
    : share_(&share),
      degree_(degree),
      at_nodes_(values_at_nodes<dim>(degree, share.degree())),
      handler_(share.triangulation()) {
  const dealii::FESystem<dim> element(
      dealii::FE_Q<dim>(static_cast<unsigned>(degree)), dim);
  handler_.distribute_dofs(element);
  dealii::IndexSet relevant;
  dealii::DoFTools::extract_locally_relevant_dofs(handler_, relevant);
  held_.reinit(relevant);
  std::vector<global_dof_index> dofs(element.n_dofs_per_cell());
  for (const auto& cell : handler_.active_cell_iterators()) {
    if (cell->is_artificial()) continue;
    const auto functions =
        held_functions<dim>(at_nodes_, share.at(cell).is_held);
    cell->get_dof_indices(dofs);
    for (unsigned i = 0; i < dofs.size(); ++i) {
      const auto [component, function] = element.system_to_component_index(i);
      if (functions[component][function]) held_.add_line(dofs[i]);
    }
  }
  held_.close();
}

template <int dim>
std::vector<int> own_numbering(const DegreeSpace<dim>& space) {
  const auto& handler = space.handler();
  const dealii::IndexSet& owned = handler.locally_owned_dofs();
  std::vector<int> result(owned.n_elements(), -1);
  std::vector<global_dof_index> dofs(handler.get_fe().n_dofs_per_cell());
  for (const auto& cell : handler.active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    const auto& nodes = space.share().at(cell).nodes;
    cell->get_dof_indices(dofs);
    for (unsigned i = 0; i < dofs.size(); ++i) {
      if (!owned.is_element(dofs[i])) continue;
      const auto [component, function] =
          handler.get_fe().system_to_component_index(i);
      const int number = dim * nodes[function] + static_cast<int>(component);
      int& entry = result[owned.index_within_set(dofs[i])];
      if (entry >= 0 && entry != number) {
        throw Error("X001", "deal.II engine",
                    "its nodes are not those of the discretisation",
                    "Please report this scene.");
      }
      entry = number;
    }
  }
  return result;
}

template class DegreeSpace<2>;
template class DegreeSpace<3>;
template std::vector<int> own_numbering<2>(const DegreeSpace<2>&);
template std::vector<int> own_numbering<3>(const DegreeSpace<3>&);

}  // namespace clevis::elasticity
