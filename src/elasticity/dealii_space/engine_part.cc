#include "elasticity/dealii_space/engine_part.h"

#include <algorithm>
#include <cmath>

#include "elasticity/assembly/stiffness.h"
#include "elasticity/multigrid/large_part.h"

namespace clevis::elasticity {
namespace {

template <int dim>
int points_a_direction(const Discretization<dim>& discretization) {
  const auto points = stiffness_quadrature(discretization).weights.size();
  return static_cast<int>(
      std::lround(std::pow(static_cast<double>(points), 1.0 / dim)));
}

template <int dim>
std::vector<BedFace> bed_faces(const Discretization<dim>& discretization,
                               const FoundationStiffness<dim>& bed) {
  std::vector<BedFace> result;
  for (const auto& face : bed.faces()) {
    const auto cell = static_cast<std::size_t>(face.cell);
    const auto& nodes = discretization.cell_nodes[cell];
    const auto size = static_cast<unsigned>(face.matrix.rows());
    BedFace entry{cell, {}, dealii::FullMatrix<double>(size, size)};
    for (const int node : face.nodes) {
      entry.nodes.push_back(
          static_cast<int>(std::ranges::find(nodes, node) - nodes.begin()));
    }
    for (unsigned i = 0; i < size; ++i) {
      for (unsigned j = 0; j < size; ++j) {
        entry.matrix(i, j) = face.matrix(i, j);
      }
    }
    result.push_back(std::move(entry));
  }
  return result;
}

}  // namespace

template <int dim>
EnginePart engine_part(const DealiiTask<dim>& task) {
  const auto& discretization = task.discretization;
  const auto lame = lame_constants<dim>(task.material);
  return {.degree = discretization.degree,
          .geometry_degree = discretization.geometry_degree,
          .gauss_points = points_a_direction(discretization),
          .nodes = discretization.nodes,
          .aspect = cell_aspect(discretization),
          .most_factored = task.most_factored,
          .stiffness = {lame.lambda * discretization.thickness,
                        lame.mu * discretization.thickness},
          .beds = bed_faces(discretization, task.bed),
          .place = task.place};
}

template EnginePart engine_part<2>(const DealiiTask<2>&);
template EnginePart engine_part<3>(const DealiiTask<3>&);

}  // namespace clevis::elasticity
