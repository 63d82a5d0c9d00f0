#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "loads/history/load_history.h"
#include "mesh/cells/part_mesh.h"
#include "part/material.h"

namespace clevis::elasticity {

/// Strain energy of a free part under loads in balance plus amounts z of
/// patterns that balance themselves: U0 + bᵀ z + ½ zᵀ A z.
struct PatternEnergy {
  Eigen::MatrixXd A;  ///< [J]
  Eigen::VectorXd b;  ///< [J]
};

/// Each seat takes its wrench as a traction linear over the group, so that the
/// energy is a quadratic form.
/// @param history   one instant, in balance.
/// @param patterns  each one wrench per seat.
/// @throws Error as of solve().
/// Source: docs/theory.md, "Parts held by pins".
PatternEnergy pattern_energy(
    const mesh::PartMesh<3>& mesh, const part::Material& material,
    loads::LoadHistory history,
    const std::vector<std::vector<loads::Wrench>>& patterns,
    const std::string& name);

}  // namespace clevis::elasticity
