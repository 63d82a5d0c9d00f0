#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/request/options.h"
#include "report/check/check_inputs.h"
#include "scene/scene.h"

namespace clevis::app {

/// Part and fingerprint of its geometry with what the part gives to it, of
/// those that have one. @throws Error as geometry_content().
std::vector<std::pair<std::string, std::string>> geometry_fingerprints(
    const scene::Scene& scene);

/// Part and fingerprint of its mesh, of those whose mesh nobody makes of a
/// geometry.
std::vector<std::pair<std::string, std::string>> given_mesh_fingerprints(
    const scene::Scene& scene);

/// Inputs of a check with these options, from the files as they are.
/// @param scene  of the options.
/// @throws Error S001, I001 as scene_content().
report::CheckInputs check_inputs(const Options& options,
                                 const scene::Scene& scene);

}  // namespace clevis::app
