#include "app/variants/check_inputs.h"

#include <fstream>
#include <iterator>

#include "app/scenes/geometry_stamp.h"
#include "base/bytes/fingerprint.h"

namespace clevis::app {
namespace {

/// Of what is no file that can be read: of nothing.
std::string file_fingerprint(const std::filesystem::path& file) {
  std::error_code failure;
  if (!std::filesystem::is_regular_file(file, failure)) return fingerprint("");
  std::ifstream stream(file, std::ios::binary);
  return fingerprint(std::string(std::istreambuf_iterator<char>(stream), {}));
}

}  // namespace

std::vector<std::pair<std::string, std::string>> geometry_fingerprints(
    const scene::Scene& scene) {
  std::vector<std::pair<std::string, std::string>> found;
  for (std::size_t p = 0; p < scene.parts.size(); ++p) {
    const part::PartDefinition& part = scene.parts[p];
    if (part.geometry.empty()) continue;
    found.emplace_back(part.name, geometry_stamp(part, scene.inputs[p]));
  }
  return found;
}

std::vector<std::pair<std::string, std::string>> given_mesh_fingerprints(
    const scene::Scene& scene) {
  std::vector<std::pair<std::string, std::string>> found;
  for (const part::PartDefinition& part : scene.parts) {
    if (!part.geometry.empty()) continue;
    found.emplace_back(part.name, file_fingerprint(part.mesh));
  }
  return found;
}

report::CheckInputs check_inputs(const Options& options,
                                 const scene::Scene& scene) {
  report::CheckInputs inputs;
  inputs.version = CLEVIS_VERSION;
  for (const scene::Setting& setting : options.settings) {
    inputs.settings.emplace_back(setting.path, setting.value);
  }
  inputs.scene =
      fingerprint(scene::scene_content(options.scene, options.settings));
  inputs.tolerance = options.tolerance;
  inputs.model = options.model;
  inputs.engine = options.engine;
  inputs.max_dofs = options.max_dofs;
  inputs.parts = options.parts;
  inputs.geometries = geometry_fingerprints(scene);
  for (const part::PartDefinition& part : scene.parts) {
    inputs.meshes.emplace_back(part.name, file_fingerprint(part.mesh));
  }
  return inputs;
}

}  // namespace clevis::app
