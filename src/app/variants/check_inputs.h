#pragma once

#include "app/request/options.h"
#include "report/check/check_inputs.h"
#include "scene/scene.h"

namespace clevis::app {

/// Inputs of a check with these options, from the files as they are.
/// @param scene  of the options.
/// @throws Error S001, I001 as scene_content().
report::CheckInputs check_inputs(const Options& options,
                                 const scene::Scene& scene);

}  // namespace clevis::app
