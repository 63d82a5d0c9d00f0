#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace clevis::app {

/// A command that makes a folder overwrites nothing.
/// @throws Error I005 if `folder` is there and not an empty folder.
void require_new_folder(const std::filesystem::path& folder);

/// The files of a new scene, and its folder if that is new too.
class NewScene {
 public:
  /// @throws Error I005 as require_new_folder().
  explicit NewScene(std::filesystem::path folder);

  std::filesystem::path scene() const { return folder_ / "scene.toml"; }

  /// @throws Error I002.
  void write(const std::string& name, std::string_view content);

  /// Writes scene.toml, which names the schema for editors, and that.
  /// @throws Error I002.
  void write_scene(std::string_view text);

  /// Whether clevis reads the scene that was written: its refusal leaves
  /// nothing behind, and names the file that the scene was made of and the
  /// body, joint or force in it. @throws Error S….
  void require_readable(const std::filesystem::path& source) const;

 private:
  void remove() const;

  std::filesystem::path folder_;
  bool is_made_;
  std::vector<std::filesystem::path> files_;
};

}  // namespace clevis::app
