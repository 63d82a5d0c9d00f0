#pragma once

#include <ostream>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "mesh/cells/part_mesh.h"
#include "part/pose.h"
#include "stress/field/stress_history.h"

namespace clevis::stress {

/// A named scalar at every lattice point of every cell.
struct ScalarField {
  std::string name, unit;
  Eigen::MatrixXd values;  ///< points × cells
};

enum class CellOrder {
  kLagrange,  ///< one VTK Lagrange cell of the lattice's order per tensor cell
  kLinear,    ///< the lattice as linear sub-cells, for readers without them
};

/// Writes displacement (m), stress_xx … stress_xz and von_mises (Pa) of an
/// instant with extra scalars as VTU, in SI; units stand at each array.
/// Displacement is turned with the part, stresses stay in frame L.
/// Repeatable: no date, fixed compression.
/// @param dim  of the cells (2: a plate's mid-plane in space).
template <int dim>
void write_vtu(std::ostream& out, mesh::CellShape shape,
               const InstantField& field,
               const std::vector<ScalarField>& scalars, CellOrder order,
               const part::Pose& pose = {});

}  // namespace clevis::stress
