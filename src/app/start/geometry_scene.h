#pragma once

#include <filesystem>
#include <string>

namespace clevis::app {

/// A scene of a solid from a CAD system as a part alone, and the copy of the
/// file that goes beside it.
struct GeometryScene {
  std::string text;  ///< scene.toml
  std::string file;  ///< name of the copy
  std::string part;  ///< name of the part
  std::string told;  ///< what it is, how it is held and loaded: a line or two
};

/// Finds the bores and plane faces of a STEP, IGES or BREP file by the mesher,
/// and writes a scene that holds and pulls the part by them.
/// @throws Error I001, M015 of no such file; M010, M016, M007 of the mesher;
///   M017 if nothing shows how the part may be held and pulled.
GeometryScene geometry_scene(const std::filesystem::path& file);

}  // namespace clevis::app
