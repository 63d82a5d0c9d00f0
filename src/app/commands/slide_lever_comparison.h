#pragma once

#include "mechanism/definition/motion.h"
#include "report/summary/motion_report.h"
#include "scene/scene.h"

namespace clevis::app {

/// The scene's [closed_form.slide_lever] beside its motion.
/// @pre scene.slide_lever is set.
/// @throws Error S006 if the triangle FED of the closed form does not close
///   at a cylinder length of the motion.
report::SlideLeverComparison compare_slide_lever(
    const scene::Scene& scene, const mechanism::Motion& motion);

}  // namespace clevis::app
