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
};

/// Stiffness of a bed under one face, at the discretisation's nodes.
struct BedFace {
  std::size_t cell{};                 ///< of the discretisation
  std::vector<int> nodes;             ///< of the face, numbers within the cell
  dealii::FullMatrix<double> matrix;  ///< dim nodes × dim nodes [N/m]
};

/// What every rank knows of a part that the engine solves: all but its cells.
struct EnginePart {
  int degree{};
  int geometry_degree{};
  int gauss_points{};  ///< of the stiffness, a direction
  int nodes{};         ///< of the discretisation
  CellStiffness stiffness;
  std::vector<BedFace> beds;
  std::string place;  ///< for messages ("part DCE")
};

template <int dim>
EnginePart engine_part(const DealiiTask<dim>& task);

/// That of the first rank, on all.
/// @param part  of the first rank; elsewhere whatever.
EnginePart broadcast(const EnginePart& part, MPI_Comm ranks);

}  // namespace clevis::elasticity
