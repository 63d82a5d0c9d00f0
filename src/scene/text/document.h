#pragma once

#include <filesystem>
#include <string>

#include <toml++/toml.h>

namespace clevis::scene {

/// A scene file as a tree of TOML nodes that know their line and column.
struct Document {
  std::string file;  ///< as the user wrote it, for messages
  toml::table root;
};

/// @throws Error I001 if it is no readable file, S001 if it is not TOML.
Document read_document(const std::filesystem::path& file);

}  // namespace clevis::scene
