#include "scene/text/strict_table.h"

#include <algorithm>

#include <fmt/format.h>

#include "scene/text/keys.h"
#include "scene/text/name_index.h"
#include "scene/text/suggestion.h"

namespace clevis::scene {
namespace {

/// How messages name a table: as its header in the file.
std::string header(const std::string& path) {
  return path.empty() ? "the scene" : "[" + path + "]";
}

}  // namespace

StrictTable::StrictTable(const Value& value, std::string_view path)
    : value_(value), path_(path), table_(value.node().as_table()) {
  const auto known = keys_of(path);
  for (const auto& [key, entry] : value.entries()) {  // in the file's order
    if (std::ranges::find(known, key) != known.end()) continue;
    throw Error("S002",
                place_of(value.file(), table_->find(key)->first.source()),
                fmt::format("{} has no key \"{:.64}\"", header(path_), key),
                suggestion(key, {known.begin(), known.end()}));
  }
}

std::string StrictTable::path_of(std::string_view key) const {
  return path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
}

bool StrictTable::has(std::string_view key) const {
  return table_->contains(key);
}

std::optional<Value> StrictTable::find(std::string_view key) {
  read_.emplace(key);
  const toml::node* node = table_->get(key);
  if (node == nullptr) return std::nullopt;
  return Value(*node, path_of(key), value_.file());
}

Value StrictTable::operator[](std::string_view key) {
  if (auto value = find(key)) return *value;
  throw refusal("S003", fmt::format("lacks the key \"{}\"", key),
                fmt::format("Add {}; docs/scene.md describes it.", key));
}

StrictTable StrictTable::table(std::string_view key) {
  return {(*this)[key], path_of(key)};
}

std::vector<StrictTable> StrictTable::tables(std::string_view key) {
  std::vector<StrictTable> tables;
  const auto value = find(key);
  if (!value) return tables;
  if (!value->node().is_array()) {
    throw value->refusal(
        "S005", "is not an array of tables",
        fmt::format("Write [[{}]] with two brackets.", path_of(key)));
  }
  for (const Value& element : value->elements()) {
    tables.emplace_back(element, path_of(key));
  }
  return tables;
}

Error StrictTable::refusal(std::string_view code, std::string_view problem,
                           std::string remedy) const {
  return Error(code, place(), fmt::format("{} {}", header(path_), problem),
               std::move(remedy));
}

void StrictTable::finish(std::string_view why) const {
  for (const auto& [key, entry] : value_.entries()) {
    if (read_.contains(key)) continue;
    const auto rival = std::ranges::find_if(rivals(), [&](const Rivals& two) {
      return two.path == path_ && two.key == key && has(two.winner);
    });
    throw Error("S010",
                place_of(value_.file(), table_->find(key)->first.source()),
                rival != rivals().end()
                    ? fmt::format("{} has both \"{}\" and \"{}\", which "
                                  "exclude each other",
                                  header(path_), rival->winner, key)
                    : fmt::format("{} has \"{}\", which means nothing {}",
                                  header(path_), key, why),
                "Remove the key, or correct what it contradicts.");
  }
}

}  // namespace clevis::scene
