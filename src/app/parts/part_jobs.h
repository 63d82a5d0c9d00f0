#pragma once

#include <string>
#include <vector>

#include "app/scenes/load_scene.h"
#include "assessment/job/part_job.h"
#include "mechanism/definition/motion.h"

namespace clevis::app {

/// @throws Error U001 for a part that the scene does not have.
void require_parts(const LoadedScene& loaded,
                   const std::vector<std::string>& names);

/// Jobs of each part that is asked for: loads over the motion
/// of its body, and its own cases, those with the same supports as one set.
/// @param names  of the parts; empty: all.
/// @param tolerance  of the peak stress, relative [1].
/// @throws Error of require_parts(), S003 for a part that nothing loads, L…,
///   M003.
std::vector<assessment::PartJob> part_jobs(
    const LoadedScene& loaded, const mechanism::Motion& motion,
    const std::vector<std::string>& names, double tolerance);

}  // namespace clevis::app
