#pragma once

#include "beam/sections/pin_line.h"
#include "loads/history/load_history.h"
#include "loads/holds/holding_groups.h"

namespace clevis::beam {

/// Largest displacement [m] of a beam's axis at its seats and stations over
/// the load history.
///
/// Elongation ∫ N/(EA) ds and the double integral of M/(EI), both taken as
/// linear between stations and extended linearly to the outer seats. The
/// rigid motion is chosen so that the first seat that holds the part rests and
/// the second stays on the line, or the slope at a single one.
/// Left out: shear deformation, the seats' own compliance.
/// @param hold  one of loads::holding_groups; of a line that does not pass
///   through it, its first bearing seats.
double beam_deflection(const PinLine& line, const loads::LoadHistory& history,
                       const loads::HoldingGroups& hold, double youngs_modulus);

}  // namespace clevis::beam
