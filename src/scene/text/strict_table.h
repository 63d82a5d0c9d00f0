#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "scene/text/value.h"

namespace clevis::scene {

/// A table of the scene that takes only the keys of the format, and notices
/// those that nobody reads.
class StrictTable {
 public:
  /// @param path  row of scene_tables().
  /// @throws Error S005 if the value is no table, S002 at the first key that
  ///   the format does not know.
  StrictTable(const Value& value, std::string_view path);

  std::string place() const { return value_.place(); }

  bool has(std::string_view key) const;
  /// @throws Error S003 if the key is absent.
  Value operator[](std::string_view key);
  std::optional<Value> find(std::string_view key);

  /// The table under a key. @throws Error S003, S005, S002.
  StrictTable table(std::string_view key);
  /// The tables of an array of tables; none if the key is absent.
  std::vector<StrictTable> tables(std::string_view key);

  /// An error at the table itself.
  Error refusal(std::string_view code, std::string_view problem,
                std::string remedy) const;

  /// Refuses keys that were given but never read: they contradict others.
  /// @param why  what makes them meaningless, e.g. "with law = \"ramp\"".
  /// @throws Error S010.
  void finish(std::string_view why) const;

 private:
  std::string path_of(std::string_view key) const;

  Value value_;
  std::string path_;
  const toml::table* table_;
  std::set<std::string, std::less<>> read_;
};

}  // namespace clevis::scene
