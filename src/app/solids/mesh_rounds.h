#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "assessment/job/part_job.h"
#include "cad/exchange.h"

namespace clevis::app {

/// A part as it was checked last, and its answer.
struct CheckedPart {
  assessment::PartJob job;
  assessment::PartAssessment assessment;
};

/// The refinement of the next mesh: where the places stand, as much as their
/// error asks for; without places three times at the peak and a quarter
/// everywhere.
/// @param last  that the mesh so far was made with.
/// @param peak  where it stands [m].
cad::Refinement finer_mesh(cad::Refinement last,
                           const std::vector<assessment::OpenPlace>& places,
                           const Eigen::Vector3d& peak);

/// What finer meshes may take.
struct RoundLimits {
  int rounds{};                   ///< at most
  std::optional<double> seconds;  ///< of the part before the last one begins
};

/// Checks a part on finer and finer meshes until the mesh leaves its peak open
/// by no more than the tolerance, a limit is met, or it has 20 000 cells, of
/// which the next would take minutes. The last mesh is checked with all
/// degrees, and so is the last that could be made, unless the time is over, and
/// one of hardly more cells than the one before it, where that was open by
/// little.
/// Notes tell each round; seconds are those of all.
/// @param check   as assessment::check_part().
/// @param mesh_again  the part on a mesh with such a refinement; `in_space` if
///   solid cells leave it open by more than a quarter: swept ones are as fine
///   all along, and tetrahedra need fewer.
CheckedPart check_in_rounds(
    assessment::PartJob job, RoundLimits limits,
    const std::function<assessment::PartAssessment(const assessment::PartJob&)>&
        check,
    const std::function<assessment::PartJob(const cad::Refinement&,
                                            bool in_space)>& mesh_again);

}  // namespace clevis::app
