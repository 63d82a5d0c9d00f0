#pragma once

#include <optional>
#include <vector>

#include "assessment/job/part_job.h"
#include "assessment/models/level.h"
#include "stress/peaks/peak_band.h"

namespace clevis::assessment {

/// The peak of a level by higher degrees in its neighbourhood alone, at the
/// instant of the peak; nothing if these cannot be solved for.
/// @param sets  that the level was solved for.
/// @param before  peak of the degree before [Pa].
template <int dim>
std::optional<stress::LocalValues> local_peak(const PartJob& job,
                                              const std::vector<LoadSet>& sets,
                                              const mesh::PartMesh<dim>& mesh,
                                              const Level<dim>& level,
                                              double before);

}  // namespace clevis::assessment
