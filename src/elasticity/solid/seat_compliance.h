#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "loads/history/load_history.h"
#include "mesh/cells/part_mesh.h"
#include "part/mass_properties.h"
#include "part/material.h"

namespace clevis::elasticity {

/// How a free part gives way at its seats: mean displacement and turn of each
/// about its p_LS, in L, beside the part's rigid motion; loads are held by its
/// inertia. Twice the strain energy of wrenches W, of products s of a spin and
/// of wrenches P elsewhere is Wᵀ C W + 2 Wᵀ D s + 2 Wᵀ G P, and what spin and P
/// alone have.
struct SeatCompliance {
  /// C, per force [N] and moment [N m]: 6 n × 6 n, symmetric, per seat force
  /// and then moment.
  Eigen::MatrixXd by_wrench;
  /// D, per ω_x², ω_y², ω_z², ω_x ω_y, ω_x ω_z, ω_y ω_z in L [rad²/s²]: 6 n
  /// × 6.
  Eigen::MatrixXd by_spin;
  /// G, per force [N] and moment [N m]: 6 n × 6 m.
  Eigen::MatrixXd by_load;
};

/// Each seat takes its wrench as a traction linear over the group, so that C is
/// linear; a pin that presses on half a bore indents it more.
/// @param loaded  seats elsewhere, m of them.
/// @return displacements and turns by 1 N, 1 N m, 1 rad²/s².
/// @throws Error as of solve().
/// Source: docs/theory.md, "Reactions".
SeatCompliance seat_compliance(const mesh::PartMesh<3>& mesh,
                               const part::Material& material,
                               const part::MassProperties& mass,
                               std::vector<loads::Seat> seats,
                               std::vector<loads::Seat> loaded,
                               const std::string& name);

}  // namespace clevis::elasticity
