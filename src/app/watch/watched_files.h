#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/request/options.h"

namespace clevis::app {

/// What a check reads: the scene, its load histories, the geometries of its
/// parts with all that these read, and meshes.
class WatchedFiles {
 public:
  explicit WatchedFiles(const Options& options) : options_(options) {}

  /// Reads anew which files they are, and notes their state. While the scene
  /// cannot be read, those known from before stay.
  void look();

  /// Whether meshes that have become those of `clevis mesh`, by the stamp of
  /// their geometry, count as changed.
  enum class OwnMeshes { kCount, kPass };

  /// A file whose state is another than noted; empty if there is none.
  std::filesystem::path changed(OwnMeshes own) const;

  /// Notes the state of meshes that `check` has made.
  void take_own_meshes();

  /// The states of all now, in one text.
  std::string states() const;

  /// Folders of the meshes.
  std::vector<std::filesystem::path> mesh_folders() const;

  std::size_t size() const { return files_.size(); }

 private:
  struct File {
    std::filesystem::path path;
    bool is_mesh{};
    std::string state;
  };
  void add(const std::filesystem::path& path, bool is_mesh);

  const Options& options_;
  std::vector<File> files_;
};

}  // namespace clevis::app
