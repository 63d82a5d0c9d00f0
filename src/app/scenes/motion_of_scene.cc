#include "app/scenes/motion_of_scene.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "mechanism/simulate.h"
#include "report/text/progress.h"

namespace clevis::app {
namespace {

/// Joints with a seat of a length that travels along a part.
std::vector<int> travelling(const scene::Scene& scene) {
  const auto& joints = scene.mechanism.joints;
  std::vector<int> found;
  for (const part::PartDefinition& part : scene.parts) {
    for (const part::Seat& seat : part.seats) {
      if (!seat.slide.length) continue;
      const auto joint = std::ranges::find(joints, seat.joint,
                                           &mechanism::JointDefinition::name);
      if (joint == joints.end()) continue;
      found.push_back(static_cast<int>(joint - joints.begin()));
    }
  }
  return found;
}

}  // namespace

mechanism::Motion motion_of_scene(const scene::Scene& scene,
                                  const Options& options) {
  constexpr int kPercent = 100;
  report::Progress progress;
  mechanism::SimulationSettings settings = scene.simulation;
  settings.at_peaks = true;
  settings.max_time = options.max_time.value_or(settings.max_time);
  settings.slides = travelling(scene);
  settings.progress = [&](double share) {
    const auto done = static_cast<int>(std::lround(kPercent * share));
    progress.update(std::clamp(done, 0, kPercent), kPercent,
                    "integrating the motion");
  };
  return mechanism::simulate(scene.mechanism, settings);
}

}  // namespace clevis::app
