#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <deal.II/lac/full_matrix.h>

#include "elasticity/dealii_space/dealii_task.h"

namespace clevis::elasticity {

/// Lamé's constants times the thickness of a plate.
struct CellStiffness {
  double lambda{}, mu{};  ///< [Pa], for dim = 2 [N/m]
  void serialize(auto& archive, unsigned) { archive& lambda& mu; }
};

/// Stiffness of a bed under one face, at the discretisation's nodes.
struct BedFace {
  std::size_t cell{};                 ///< of the discretisation
  std::vector<int> nodes;             ///< of the face, numbers within the cell
  dealii::FullMatrix<double> matrix;  ///< dim nodes × dim nodes [N/m]
  void serialize(auto& archive, unsigned) { archive& cell& nodes& matrix; }
};

/// What every rank knows of a part that the engine solves: all but its cells.
struct EnginePart {
  int degree{};
  int geometry_degree{};
  int gauss_points{};      ///< of the stiffness, a direction
  int nodes{};             ///< of the discretisation
  double aspect{};         ///< cell_aspect() of the discretisation [1]
  double most_factored{};  ///< equations of the coarsest level
  CellStiffness stiffness;
  std::vector<BedFace> beds;
  std::string place;  ///< for messages ("part DCE")
  void serialize(auto& archive, unsigned) {
    archive& degree& geometry_degree& gauss_points& nodes& aspect;
    archive& most_factored& stiffness& beds& place;
  }
};

template <int dim>
EnginePart engine_part(const DealiiTask<dim>& task);

}  // namespace clevis::elasticity
