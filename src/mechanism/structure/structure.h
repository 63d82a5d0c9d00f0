#pragma once

#include <string>
#include <vector>

#include "mechanism/definition/definition.h"

namespace clevis::mechanism {

/// Structural analysis of a mechanism.
struct Structure {
  bool planar{};
  int moving_links{};  ///< bodies, welded ones counted once
  int pairs{};         ///< joints, welds left out
  int chebyshev{};  ///< W = 3n − 2p5 − p4 (planar) or 6n − Σ constraints
  int mobility{};   ///< columns − rank of the constraint Jacobian
  int redundant{};  ///< rows − rank
  /// Joints with constraints that depend on others.
  std::vector<std::string> redundant_in;
  /// The same mechanism taken as spatial.
  int spatial_chebyshev{}, spatial_mobility{}, spatial_redundant{};
  std::vector<std::string> spatial_redundant_in;
  // Assur groups; empty and 0 if the mechanism is not planar or has none.
  std::string assur_corrected;  ///< "I(cylinder) -> II(DCE,FE1+FE2) -> …"
  std::string assur_published;  ///< the remainder taken as one group
  int assur_class_corrected{}, assur_class_published{};
  /// Joints taken as inputs because no drive moves them.
  std::vector<std::string> assur_inputs;
  std::string assur_none;  ///< why a planar mechanism does not split
};

/// Mobility by Chebyshev and by the rank of the constraint Jacobian, redundant
/// constraints, Assur groups of planar mechanisms.
/// @throws Error K001 if the joints do not close.
Structure analyse_structure(const MechanismDefinition& definition);

}  // namespace clevis::mechanism
