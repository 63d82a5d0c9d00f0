#pragma once

#include <string>
#include <vector>

#include "assessment/job/part_job.h"

namespace clevis::assessment {

/// Notes on the part as given: of one that stands alone its size and mass, for
/// no joint confirms the unit of its lengths; what few links of mechanisms have
/// (size, thickness, damping), what no material has (yield strength, stiffness,
/// density, Poisson's ratio), a deflection limit of a part of its
/// size, accelerations as of numbers in mm/s², a case that is nothing beside
/// another, physical groups that hold nothing.
std::vector<std::string> part_notes(const PartJob& job);

/// Notes on how much of its strength the part's loads use: less than a
/// hundredth, or a hundred times as much.
/// @param safety_factor  with vibration; 0: nothing stresses it.
std::vector<std::string> strength_notes(double safety_factor);

}  // namespace clevis::assessment
