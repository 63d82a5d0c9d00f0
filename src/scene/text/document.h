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

/// The bytes of a file that the user wrote.
/// @throws Error I001 if it is no regular file, cannot be read or is larger
///   than 16 MiB.
std::string read_text(const std::filesystem::path& file);

/// @throws Error I001 if it is no readable file, S001 if it is not TOML or by
///   its name a file of another kind, such as STEP.
Document read_document(const std::filesystem::path& file);

}  // namespace clevis::scene
