#include "app/pictures/view_inputs.h"

namespace clevis::app {

std::vector<report::ViewInput> view_inputs(const scene::Scene& scene) {
  std::vector<report::ViewInput> inputs{{scene.file, "scene"}};
  for (const auto& part : scene.parts) {
    if (std::filesystem::exists(part.geometry)) {
      inputs.push_back({part.geometry, "geometry of " + part.name});
    }
    inputs.push_back({part.mesh, "mesh of " + part.name});
  }
  return inputs;
}

}  // namespace clevis::app
