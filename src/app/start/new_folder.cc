#include "app/start/new_folder.h"

#include <system_error>
#include <utility>

#include "app/start/templates.h"
#include "base/messages/errors.h"
#include "report/text/atomic_file.h"
#include "scene/scene.h"

namespace clevis::app {

namespace fs = std::filesystem;

void require_new_folder(const fs::path& folder) {
  if (folder.empty()) {
    throw Error("U001", "folder", "its name is empty",
                "Give the name of a new folder.");
  }
  std::error_code error;
  if (!fs::exists(fs::symlink_status(folder, error))) return;
  if (fs::is_directory(folder, error) && fs::is_empty(folder, error)) return;
  throw Error("I005", folder.string(), "is there and not an empty folder",
              "Give the name of a new folder; nothing is overwritten.");
}

NewScene::NewScene(fs::path folder)
    : folder_(std::move(folder)), is_made_(!fs::exists(folder_)) {
  require_new_folder(folder_);
}

void NewScene::write(const std::string& name, std::string_view content) {
  files_.push_back(folder_ / name);
  try {
    report::write_file(files_.back(), content);
  } catch (...) {
    remove();
    throw;
  }
}

void NewScene::write_scene(std::string_view text) {
  constexpr std::string_view kSchemaLine = "#:schema ./scene.schema.json\n";
  write("scene.toml",
        (text.starts_with(kSchemaLine) ? "" : std::string(kSchemaLine)) +
            std::string(text));
  write("scene.schema.json", scene_schema());
}

void NewScene::require_readable() const {
  try {
    scene::read_scene(scene());
  } catch (...) {
    remove();
    throw;
  }
}

void NewScene::remove() const {
  std::error_code ignored;
  for (const fs::path& file : files_) fs::remove(file, ignored);
  if (is_made_) fs::remove(folder_, ignored);
}

}  // namespace clevis::app
