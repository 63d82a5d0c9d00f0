#pragma once

#include "app/scenes/load_scene.h"
#include "assessment/job/part_job.h"
#include "mechanism/definition/motion.h"

namespace clevis::app {

/// A part as it was checked last, and its answer.
struct CheckedPart {
  assessment::PartJob job;
  assessment::PartAssessment assessment;
};

/// Checks a part. Where it is a solid of a CAD system whose peak stays open by
/// more than the tolerance, meshes it finer everywhere and most at the peak,
/// keeps that mesh and checks anew; each round is told in the result's notes.
/// @param rounds  of finer meshes at most.
/// @throws Error as check_part() and mesh_solid_part().
CheckedPart check_on_finer_meshes(const LoadedScene& loaded,
                                  const mechanism::Motion& motion,
                                  const assessment::PartJob& job, int rounds);

}  // namespace clevis::app
