#pragma once

#include <vector>

#include "report/view/motion_view.h"
#include "scene/scene.h"

namespace clevis::app {

/// Files that a result is made from: the scene, then each part's geometry, if
/// it is there, and mesh.
std::vector<report::ViewInput> view_inputs(const scene::Scene& scene);

}  // namespace clevis::app
