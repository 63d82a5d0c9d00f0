#pragma once

#include <string>
#include <vector>

#include "mechanism/definition.h"

namespace clevis::mechanism {

/// Structural analysis of a mechanism (SEEDS S2).
struct Structure {
  bool planar{};
  int moving_links{};  ///< bodies, welded ones counted once
  int pairs{};         ///< joints, welds left out
  int chebyshev{};  ///< W = 3n − 2p5 − p4 (planar) or 6n − Σ constraints
  int mobility{};   ///< columns − rank of the constraint Jacobian
  int redundant{};  ///< rows − rank
  std::vector<std::string> redundant_in;  ///< joints with redundant rows
  /// The same mechanism taken as spatial.
  int spatial_chebyshev{}, spatial_mobility{}, spatial_redundant{};
  std::string assur_corrected;  ///< "I(cylinder) -> II(FE1,FE2,DCE) -> …"
  std::string assur_published;  ///< the remainder taken as one group
  int assur_class_corrected{}, assur_class_published{};
};

Structure analyse_structure(const MechanismDefinition& definition);

}  // namespace clevis::mechanism
