#pragma once

#include <functional>
#include <string>
#include <string_view>
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

/// Displacement (m), stress_xx … stress_xz and von_mises (Pa) of an instant
/// with extra scalars as VTU, in SI; units stand at each array. Displacement is
/// turned with the part, stresses stay in frame L. Repeatable: no date, fixed
/// compression.
class FieldOutput {
 public:
  /// @param dim  of the cells (2: a plate's mid-plane in space).
  FieldOutput(int dim, mesh::CellShape shape, const InstantField& field,
              const std::vector<ScalarField>& scalars,
              const part::Pose& pose = {});

  /// Hands the file on, piece after piece; both orders share the values.
  void write(CellOrder order,
             const std::function<void(std::string_view)>& sink) const;

 private:
  int dim_;
  mesh::CellShape shape_;
  int subdivisions_, cells_, points_of_a_cell_;
  std::string points_;               ///< as they stand in the file
  std::vector<std::string> values_;  ///< likewise, array after array
};

}  // namespace clevis::stress
