#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "mesh/part_mesh.h"
#include "scene/scene.h"

namespace clevis::app {

/// A scene whose bodies weigh what the meshes of their parts weigh.
struct LoadedScene {
  scene::Scene scene;
  /// Meshes of the parts that bodies have, by the part's name.
  std::map<std::string, mesh::PartMesh<3>> meshes;
};

/// Reads the scene and the meshes of its bodies' parts; mass, centre and
/// inertia of a body with a part are those of its mesh and material.
/// @throws Error S001–S011 of the scene, M001–M009 and I001 of the meshes.
LoadedScene load_mechanism(const std::filesystem::path& file);

}  // namespace clevis::app
