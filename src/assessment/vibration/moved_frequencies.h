#pragma once

#include <string>
#include <vector>

#include "assessment/job/part_job.h"
#include "assessment/job/part_result.h"
#include "assessment/stretches/held_stretches.h"

namespace clevis::assessment {

/// Why a part's vibration is not known as it spins about its length: loads that
/// change in space meet its shapes in space, which turn in its own frame;
/// empty: it is.
/// @param first  period [s].
std::string not_known_spinning(const PartJob& job, const LoadSet& given,
                               double first);

/// Doubts the vibration of a part whose first frequency is moved, by its own
/// inertia as it turns or by what presses or pulls it, to where its loads make
/// it swing farther: shapes are those at rest.
/// A part that is held otherwise from time to time is looked at meanwhile: it
/// may turn fast while it is held stiffly.
/// @param stiffening  of BucklingCheck.
/// @pre vibration and buckling are checked.
void doubt_moved_frequencies(const PartJob& job, HeldMotions& held,
                             const std::vector<double>& stiffening,
                             PartResult& result);

/// Doubts it where bodies that spin on the part move its frequencies to those
/// of its loads: their gyroscopic moment is not in the vibration.
/// @pre vibration is checked.
void doubt_spun_frequencies(const PartJob& job, HeldMotions& held,
                            PartResult& result);

}  // namespace clevis::assessment
