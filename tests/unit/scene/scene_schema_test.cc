// docs/scene.schema.json, the reader's key lists and the valid scenes under
// tests/data/scenes must speak of the same keys.
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <toml++/toml.h>

#include "scene/text/keys.h"
#include "support/source_dir.h"

namespace clevis::scene {
namespace {

using Keys = std::map<std::string, std::set<std::string>>;

Keys keys_of_reader() {
  Keys keys;
  for (const TableKeys& table : scene_tables()) {
    keys[std::string(table.path)] = {table.keys.begin(), table.keys.end()};
  }
  return keys;
}

TEST(SceneSchema, HasTheKeysOfTheReader) {
  std::ifstream file(support::source_dir() / "docs/scene.schema.json");
  const auto schema = nlohmann::json::parse(file);
  Keys keys;
  const auto add = [&keys](const std::string& path,
                           const nlohmann::json& table) {
    if (!table.contains("properties")) return;
    EXPECT_EQ(table.at("additionalProperties"), false) << path;
    for (const auto& [key, value] : table.at("properties").items()) {
      keys[path].insert(key);
      EXPECT_TRUE(value.contains("description")) << path << "." << key;
    }
  };
  add("", schema);
  for (const auto& [path, table] : schema.at("$defs").items()) {
    add(path, table);
  }
  EXPECT_EQ(keys, keys_of_reader());
}

/// Keys that a scene uses, by the path of their table.
void collect(const toml::table& table, const std::string& path, Keys& used) {
  const Keys known = keys_of_reader();
  const auto& row = known.at(path);
  for (const auto& [key, node] : table) {
    ASSERT_TRUE(row.contains(std::string(key.str())));
    used[path].insert(std::string(key.str()));
    const std::string below = path.empty()
                                  ? std::string(key.str())
                                  : path + "." + std::string(key.str());
    if (!known.contains(below)) continue;
    const bool by_name = below == "material" || below == "part.pins" ||
                         below == "part.drives" || below == "part.forces" ||
                         below == "part.case.foundation" ||
                         below == "part.faces" || below == "part.history.pins";
    if (const auto* array = node.as_array()) {
      for (const auto& element : *array) {
        collect(*element.as_table(), below, used);
      }
    } else if (by_name) {
      for (const auto& [name, element] : *node.as_table()) {
        // a pin's group or one number for all of a bed
        if (!element.is_table()) continue;
        collect(*element.as_table(), below, used);
      }
    } else {
      collect(*node.as_table(), below, used);
    }
  }
}

TEST(SceneSchema, EveryKeyIsInAValidScene) {
  Keys used;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(
           support::source_dir() / "tests/data/scenes")) {
    if (entry.path().extension() != ".toml") continue;
    collect(toml::parse_file(entry.path().string()), "", used);
  }
  EXPECT_EQ(used, keys_of_reader());
}

}  // namespace
}  // namespace clevis::scene
