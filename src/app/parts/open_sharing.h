#pragma once

#include <optional>

#include "app/scenes/load_scene.h"
#include "assessment/job/part_job.h"
#include "mechanism/reactions/other_sharings.h"

namespace clevis::app {

/// Loads on a part as joints of other compliance share the reactions that
/// equilibrium leaves open; nothing if its loads hardly depend on it.
/// @param checked  its loads by the sharing that the motion has, load set 0.
/// @throws Error as of part_loads().
std::optional<assessment::OpenSharing> open_sharing(
    const LoadedScene& loaded, const mechanism::OtherSharings& sharings,
    const LoadedPart& part, const loads::LoadHistory& checked);

}  // namespace clevis::app
