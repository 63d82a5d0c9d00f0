#pragma once

#include <optional>
#include <string>
#include <vector>

#include "loads/parts/part_loads.h"
#include "mesh/cells/part_mesh.h"
#include "part/mass_properties.h"
#include "scene/scene.h"

namespace clevis::app {

/// A part with what its mesh says of it.
struct LoadedPart {
  part::PartDefinition definition;
  mesh::PartMesh<3> mesh;
  std::optional<mesh::PartMesh<3>> unrefined;  ///< before `refine`
  part::MassProperties mass;
  std::vector<loads::GroupGeometry> groups;
  std::vector<std::string> notes;  ///< what was made of the mesh
};

/// A scene whose bodies have the masses of their parts' meshes.
struct LoadedScene {
  scene::Scene scene;
  std::vector<LoadedPart> parts;  ///< like scene.parts

  /// The body that carries the part; mechanism::kGround if none does.
  mechanism::BodyIndex body_of(const std::string& part) const;
};

/// A part with its mesh as the file holds it.
/// @throws Error M…, I001.
LoadedPart load_part(const part::PartDefinition& definition,
                     const part::GeometryInput& input);

/// A scene with the meshes of its parts.
/// @throws Error S003, M…, I001.
LoadedScene load_scene(scene::Scene scene);

/// Gives bodies with a part the mass of its mesh. Without the rest of what
/// load_scene() tells, in a fraction of its time.
/// @throws Error M…, I001.
void load_masses(scene::Scene& scene);

}  // namespace clevis::app
