#pragma once

#include <string>
#include <vector>

#include "assessment/job/part_job.h"

namespace clevis::assessment {

/// Notes on the part as given: a size that few links of mechanisms have, a
/// yield strength that no material has, a deflection limit as large as the
/// part, an acceleration of a case as of numbers in mm/s², physical groups that
/// hold nothing.
std::vector<std::string> part_notes(const PartJob& job);

}  // namespace clevis::assessment
