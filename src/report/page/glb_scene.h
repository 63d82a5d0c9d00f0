#pragma once

#include <string>

#include "report/page/result_folder.h"

namespace clevis::report {

/// The parts of a check as a glTF 2.0 file (.glb), coloured by their largest
/// stress; the rigid motion of the bodies is the animation of its nodes.
/// Metres; up is against gravity, else +y.
/// @throws Error I003, I008 if there is no part.
std::string glb_scene(const StoredPage& page);

}  // namespace clevis::report
