#pragma once

#include "loads/history/load_history.h"

namespace clevis::elasticity {

/// True if no load leaves the plane z = const (to 1e-9 of the largest): what
/// a plane model can take.
/// @param size  of the part [m]: lever of forces, whose moments are compared.
bool loads_in_plane(const loads::LoadHistory& history, double mid_plane_z,
                    double size);

}  // namespace clevis::elasticity
