#pragma once

#include "beam/sections/pin_line.h"
#include "loads/history/load_history.h"

namespace clevis::beam {

/// Largest displacement [m] of a beam's axis at its seats and stations over
/// the load history.
///
/// Elongation ∫ N/(EA) ds and the double integral of M/(EI), both taken as
/// linear between stations and extended linearly to the outer seats. The
/// rigid motion is chosen so that the first bearing seat of the line (in the
/// order of the history's seats) rests and the second stays on the line.
/// Left out: shear deformation, the seats' own compliance.
double beam_deflection(const PinLine& line, const loads::LoadHistory& history,
                       double youngs_modulus);

}  // namespace clevis::beam
