#pragma once

#include <cstddef>
#include <iosfwd>

#include "app/request/options.h"
#include "scene/scene.h"

namespace clevis::app {

/// kAll: the parts that --part names, or all. kOutdated: of all parts those
/// whose mesh is missing or of another version of its geometry.
enum class MeshWhich { kAll, kOutdated };

/// Makes the meshes of the scene's parts that have a geometry, with the values
/// of --set; a line on `log` for each, and of solids what was found. Two parts
/// of one mesh make it once.
/// @return how many of the parts in question have a geometry.
/// @throws Error M…, S007 if a named part does not exist or the .geo does not
///   take a parameter, S003 if a named part has no geometry.
std::size_t mesh_parts(const Options& options, MeshWhich which,
                       std::ostream& log);

/// Makes the missing and outdated meshes of the scene's solids: unlike a .geo a
/// CAD file runs nothing. Of several ranks none does.
/// @throws Error M….
void mesh_solids(const scene::Scene& scene, std::ostream& log);

/// The scene that a command solves, read once for all that it does, with the
/// meshes of its solids.
/// @throws Error S…, I001 as read_scene(); as mesh_parts().
scene::Scene scene_to_solve(const Options& options, std::ostream& log);

}  // namespace clevis::app
