#include "app/start/new_folder.h"

#include <fstream>
#include <limits>
#include <regex>
#include <string>
#include <system_error>
#include <utility>

#include <fmt/format.h>

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

namespace {

/// A place in a scene as one in the file that it was made of: "arm.urdf, link
/// hand" of the table [[body]] about "scene.toml:12:3".
std::string place_in(const fs::path& source, const fs::path& scene,
                     const std::string& place) {
  if (!place.starts_with(scene.string())) return place;
  static const std::regex kLine(":([0-9]{1,9}):[0-9]+$");
  static const std::regex kTable(R"(\[\[([a-z.]+)\]\].*)");
  static const std::regex kName(R"re(name = "(.*)".*)re");
  std::smatch match;
  const int line = std::regex_search(place, match, kLine)
                       ? std::stoi(match[1])
                       : std::numeric_limits<int>::max();
  std::ifstream stream(scene);
  std::string table, name, text;
  for (int at = 1; std::getline(stream, text); ++at) {
    if (text.starts_with('[')) {
      if (at > line) break;
      table = std::regex_match(text, match, kTable) ? match[1] : std::string();
      name.clear();
    } else if (std::regex_match(text, match, kName)) {
      name = match[1];
    }
  }
  return name.empty() || table.empty()
             ? source.string()
             : fmt::format("{}, {} {}", source.string(),
                           table == "body" ? "link" : table, name);
}

}  // namespace

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

void NewScene::require_readable(const fs::path& source) const {
  try {
    scene::read_scene(scene());
  } catch (const Error& error) {
    const std::string place = place_in(source, scene(), error.place());
    remove();
    throw Error(error.code(), place, error.problem(), error.remedy());
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
