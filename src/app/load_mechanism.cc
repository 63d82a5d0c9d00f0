#include "app/load_mechanism.h"

#include <algorithm>
#include <utility>

#include "mesh/mass_properties.h"
#include "mesh/mesh_reader.h"

namespace clevis::app {

LoadedScene load_mechanism(const std::filesystem::path& file) {
  LoadedScene loaded;
  loaded.scene = scene::read_scene(file);
  for (mechanism::BodyDefinition& body : loaded.scene.mechanism.bodies) {
    if (body.part.empty()) continue;
    const auto part = std::ranges::find(loaded.scene.parts, body.part,
                                        &part::PartDefinition::name);
    if (part == loaded.scene.parts.end()) continue;
    mesh::PartMesh<3> mesh =
        mesh::read_part_mesh(part->mesh, part->length_unit);
    body.mass_properties = mesh::mass_properties(mesh, part->material.density);
    loaded.meshes.emplace(part->name, std::move(mesh));
  }
  return loaded;
}

}  // namespace clevis::app
