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
/// per force [N] and moment [N m] about its p_LS, in L, beside the part's rigid
/// motion; loads are held by its inertia. Twice the strain energy of wrenches
/// W is Wᵀ C W.
///
/// Each seat takes its wrench as a traction linear over the group, so that C is
/// linear; a pin that presses on half a bore indents it more.
/// @return 6 n × 6 n, symmetric, per seat force and then moment.
/// @throws Error as of solve().
/// Source: docs/theory.md, "Reactions".
Eigen::MatrixXd seat_compliance(const mesh::PartMesh<3>& mesh,
                                const part::Material& material,
                                const part::MassProperties& mass,
                                std::vector<loads::Seat> seats,
                                const std::string& name);

}  // namespace clevis::elasticity
