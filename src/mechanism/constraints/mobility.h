#pragma once

#include <string>
#include <vector>

#include "mechanism/constraints/constraint_system.h"

namespace clevis::mechanism {

/// Degrees of freedom by the rank of the constraint Jacobian, at a general
/// configuration: where the given one is singular, a neighbour on the same
/// branch is taken.
struct Mobility {
  int joints{};       ///< columns − rank of the joints' rows
  int with_drives{};  ///< columns − rank of all rows: what no drive fixes
  int redundant{};    ///< joints' rows − rank
  std::vector<bool> dependent_rows;  ///< joints' rows among dependent ones
  /// Coordinates that the drives leave loose, as drives of them.
  std::vector<DriveDefinition> free_coordinates;
  std::vector<int> dependent_drives;  ///< drives that repeat other rows
};

/// @param system  with its drives.
Mobility mobility(const SolvingFrame& frame, const ConstraintSystem& system,
                  const Configuration& closed);

/// @throws Error K002, K003 if the drives do not fix the motion, naming
///   joints to drive or drives to remove.
void require_driven(const MechanismDefinition& definition,
                    const Mobility& mobility);

}  // namespace clevis::mechanism
