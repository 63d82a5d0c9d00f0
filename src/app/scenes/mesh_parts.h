#pragma once

#include <cstddef>
#include <iosfwd>

#include "app/request/options.h"

namespace clevis::app {

/// kAll: the parts that --part names, or all. kOutdated: of all parts those
/// whose mesh is missing or of another version of its geometry.
enum class MeshWhich { kAll, kOutdated };

/// Makes the meshes of the scene's parts that have a .geo, with the parameters
/// of --set; a line on `log` for each. Two parts of one mesh make it once.
/// @return how many of the parts in question have a .geo.
/// @throws Error M…, S007 if a named part does not exist or the .geo does not
///   take a parameter, S003 if a named part has no .geo.
std::size_t mesh_parts(const Options& options, MeshWhich which,
                       std::ostream& log);

}  // namespace clevis::app
