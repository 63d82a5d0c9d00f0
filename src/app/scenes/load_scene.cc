#include "app/scenes/load_scene.h"

#include <algorithm>
#include <future>
#include <utility>

#include <fmt/format.h>

#include "app/scenes/geometry_stamp.h"
#include "base/messages/errors.h"
#include "mesh/derived/split_cells.h"
#include "mesh/quality/mass_properties.h"
#include "mesh/reading/mesh_reader.h"

namespace clevis::app {
namespace {

std::vector<loads::GroupGeometry> group_geometry(
    const mesh::PartMesh<3>& mesh) {
  std::vector<loads::GroupGeometry> groups;
  for (std::size_t g = 0; g < mesh.groups.size(); ++g) {
    const auto faces = mesh::face_properties(mesh, static_cast<int>(g));
    loads::GroupGeometry geometry;
    geometry.name = mesh.groups[g].name;
    geometry.is_cylinder = mesh.groups[g].cylinder.has_value();
    if (geometry.is_cylinder) geometry.cylinder = *mesh.groups[g].cylinder;
    geometry.centroid = faces.centroid;
    geometry.area = faces.area;
    geometry.area_vector = faces.area_vector;
    geometry.area_moment = faces.area_moment;
    geometry.normal_square = faces.normal_square;
    geometry.second_moment = faces.second_moment;
    geometry.points = mesh::face_corners(mesh, static_cast<int>(g));
    groups.push_back(std::move(geometry));
  }
  return groups;
}

/// @throws Error M008 for other cells than hexahedra.
void refine(int pieces, LoadedPart& part) {
  if (part.mesh.shape != mesh::CellShape::kTensor) {
    throw Error("M008", "part " + part.definition.name,
                "`refine` cuts hexahedra, but the mesh has other cells",
                "Mesh the part with hexahedra, or finer.");
  }
  auto finer = mesh::refined(part.mesh, pieces);
  part.unrefined = std::exchange(part.mesh, std::move(finer));
  part.notes.push_back(fmt::format(
      "every cell of the mesh is cut into {} along each direction (refine)",
      pieces));
}

}  // namespace

LoadedPart load_part(const part::PartDefinition& definition,
                     const part::GeometryInput& input) {
  require_current_mesh(definition, input);
  LoadedPart part;
  part.definition = definition;
  auto read = mesh::read_mesh_with_notes(
      definition.mesh, definition.length_unit, definition.thickness);
  part.mesh = std::move(read.mesh);
  part.notes = std::move(read.notes);
  part.mass = mesh::mass_properties(part.mesh, definition.material.density);
  part.groups = group_geometry(part.mesh);
  if (input.refine > 1) refine(input.refine, part);
  return part;
}

mechanism::BodyIndex LoadedScene::body_of(const std::string& part) const {
  const auto& bodies = scene.mechanism.bodies;
  const auto found =
      std::ranges::find(bodies, part, &mechanism::BodyDefinition::part);
  return found == bodies.end()
             ? mechanism::kGround
             : static_cast<mechanism::BodyIndex>(found - bodies.begin());
}

LoadedScene load_scene(scene::Scene scene) {
  LoadedScene loaded;
  loaded.scene = std::move(scene);
  if (!loaded.scene.has_mechanism && loaded.scene.parts.empty()) {
    throw Error("S003", loaded.scene.file.string() + ":1:1",
                "the scene has neither [[body]] nor [[part]], so there is "
                "nothing to check",
                "Add one, or run clevis transmission.");
  }
  for (std::size_t p = 0; p < loaded.scene.parts.size(); ++p) {
    loaded.parts.push_back(
        load_part(loaded.scene.parts[p], loaded.scene.inputs[p]));
  }
  for (auto& body : loaded.scene.mechanism.bodies) {
    const auto part =
        std::ranges::find(loaded.parts, body.part, [](const LoadedPart& p) {
          return p.definition.name;
        });
    if (!body.part.empty() && part != loaded.parts.end()) {
      body.mass_properties = part->mass;
    }
  }
  return loaded;
}

void load_masses(scene::Scene& scene) {
  std::vector<std::future<part::MassProperties>> masses;
  for (std::size_t p = 0; p < scene.parts.size(); ++p) {
    require_current_mesh(scene.parts[p], scene.inputs[p]);
  }
  for (const auto& part : scene.parts) {
    masses.push_back(std::async(std::launch::async, [&part] {
      return mesh::mass_properties(
          mesh::read_part_mesh(part.mesh, part.length_unit, part.thickness),
          part.material.density);
    }));
  }
  for (std::size_t p = 0; p < scene.parts.size(); ++p) {
    const part::MassProperties mass = masses[p].get();
    for (auto& body : scene.mechanism.bodies) {
      if (body.part == scene.parts[p].name) body.mass_properties = mass;
    }
  }
}

}  // namespace clevis::app
