#pragma once

#include <string>
#include <vector>

#include "assessment/job/part_job.h"

namespace clevis::assessment {

/// Notes on the part as given: a size that few links of
/// mechanisms have, physical groups that hold nothing.
std::vector<std::string> part_notes(const PartJob& job);

}  // namespace clevis::assessment
