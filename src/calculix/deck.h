#pragma once

#include <ostream>

#include "calculix/model.h"

namespace clevis::calculix {

/// Writes the model as a CalculiX (Abaqus) input deck in N, mm, MPa and
/// tonnes: nodes, elements, a node set N_<group> and a surface S_<group> per
/// named group, material, springs of elastic beds, supports, and one *STEP per
/// column of the loads, its nodal forces as *CLOAD, displacements and stresses
/// into the .frd.
///
/// Names keep their letters, digits and underscores; others become "_".
/// Forces below 1e-12 of a step's largest are left out.
void write_deck(std::ostream& out, const Model& model);

}  // namespace clevis::calculix
