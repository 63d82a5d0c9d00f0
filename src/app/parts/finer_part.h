#pragma once

#include "app/scenes/load_scene.h"
#include "app/solids/mesh_rounds.h"
#include "assessment/job/part_job.h"
#include "mechanism/definition/motion.h"

namespace clevis::app {

/// Checks a part. Where it is a solid of a CAD system whose peak stays open by
/// more than the tolerance, meshes it finer where its error stands, keeps that
/// mesh and checks anew (check_in_rounds).
/// @throws Error as check_part() and mesh_solid_part().
CheckedPart check_on_finer_meshes(const LoadedScene& loaded,
                                  const mechanism::Motion& motion,
                                  const assessment::PartJob& job,
                                  const RoundLimits& limits);

}  // namespace clevis::app
