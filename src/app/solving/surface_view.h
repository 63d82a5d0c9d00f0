#pragma once

#include "app/solving/part_files.h"
#include "assessment/job/part_job.h"
#include "report/view/part_view.h"

namespace clevis::app {

/// The surface of a part with its fields over the instants of its governing
/// loads; all of up to 240, else as many uniform ones and the worst, and half
/// as many more that follow blows. Fewer of parts with many cells.
/// @param moving  the motion of its body, if one carries it.
report::PartView surface_view(const assessment::PartJob& job,
                              const assessment::PartAssessment& assessment,
                              const std::optional<MovingPart>& moving,
                              const std::string& body);

/// The same of a part whose check failed: its surface, without fields.
report::PartView shape_view(const assessment::PartJob& job,
                            const std::string& body);

}  // namespace clevis::app
