#include "app/watch/watched_files.h"

#include <algorithm>

#include <fmt/format.h>
#include <sys/stat.h>

#include "app/scenes/geometry_files.h"
#include "app/scenes/geometry_stamp.h"
#include "base/messages/errors.h"
#include "scene/scene.h"

namespace clevis::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMissing = "missing";
constexpr const char* kOwnMesh = "made from its geometry";

/// Differs whenever a file was written, replaced, removed or is another kind of
/// thing. A mesh that `clevis mesh` made is as its geometry is.
std::string state_of(const fs::path& file, bool is_mesh) {
  struct stat found {};
  if (stat(file.c_str(), &found) != 0) return kMissing;
  if (is_mesh && S_ISREG(found.st_mode) && stamp_of(file)) return kOwnMesh;
  return fmt::format("{}:{}:{}:{}:{}.{}", found.st_mode, found.st_dev,
                     found.st_ino, found.st_size, found.st_mtim.tv_sec,
                     found.st_mtim.tv_nsec);
}

}  // namespace

void WatchedFiles::add(const fs::path& path, bool is_mesh) {
  if (std::ranges::find(files_, path, &File::path) != files_.end()) return;
  files_.push_back({path, is_mesh, state_of(path, is_mesh)});
}

void WatchedFiles::look() {
  const std::vector<File> before = std::move(files_);
  files_.clear();
  // First its state, then what stands in it: a change in between is seen.
  add(options_.scene, false);
  try {
    const auto named = scene::named_files(options_.scene, options_.settings);
    for (const fs::path& history : named.histories) add(history, false);
    for (const fs::path& geometry : named.geometries) {
      for (const fs::path& file : geometry_files(geometry)) add(file, false);
    }
    for (const fs::path& mesh : named.meshes) add(mesh, true);
    for (const auto& part :
         scene::read_scene(options_.scene, options_.settings).parts) {
      add(part.mesh, true);
    }
  } catch (const Error&) {  // the check tells it
    for (const File& file : before) add(file.path, file.is_mesh);
  }
}

fs::path WatchedFiles::changed(OwnMeshes own) const {
  const auto found = std::ranges::find_if(files_, [own](const File& file) {
    const std::string now = state_of(file.path, file.is_mesh);
    return now != file.state && !(own == OwnMeshes::kPass && now == kOwnMesh);
  });
  return found == files_.end() ? fs::path() : found->path;
}

void WatchedFiles::take_own_meshes() {
  for (File& file : files_) {
    if (file.is_mesh && state_of(file.path, true) == kOwnMesh) {
      file.state = kOwnMesh;
    }
  }
}

std::string WatchedFiles::states() const {
  std::string all;
  for (const File& file : files_) {
    all += state_of(file.path, file.is_mesh) + '\n';
  }
  return all;
}

std::vector<fs::path> WatchedFiles::mesh_folders() const {
  std::vector<fs::path> folders;
  for (const File& file : files_) {
    const fs::path folder = fs::absolute(file.path).parent_path();
    if (file.is_mesh && std::ranges::find(folders, folder) == folders.end()) {
      folders.push_back(folder);
    }
  }
  return folders;
}

}  // namespace clevis::app
