#include "scene/variants/apply_settings.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "base/messages/errors.h"
#include "scene/text/keys.h"
#include "scene/text/suggestion.h"
#include "scene/variants/key_path.h"

namespace clevis::scene {
namespace {

using Path = std::vector<PathStep>;

/// A key with a value of its own place, from TOML text.
toml::table parsed(const std::string& text, const std::string& place) {
  return toml::parse("v = " + text, std::string_view(place));
}

/// The text as a TOML string.
std::string quoted(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + '"';
}

/// Value of a setting: TOML if it is that, else a text.
toml::table value_table(const Setting& setting) {
  try {
    toml::table table = parsed(setting.value, setting.place);
    if (table.size() == 1) return table;
  } catch (const toml::parse_error&) {
  }
  try {
    return parsed(quoted(setting.value), setting.place);
  } catch (const toml::parse_error& failure) {
    throw Error("S001", setting.place,
                fmt::format("the value is no text: {}", failure.description()),
                "Write it in UTF-8, without line breaks.");
  }
}

/// The name by which the scene knows an entry of a list.
std::optional<std::string> name_of(const toml::node& entry) {
  const auto* table = entry.as_table();
  if (table == nullptr) return std::nullopt;
  for (const char* key : {"name", "joint", "body"}) {
    if (const auto name = (*table)[key].value<std::string>()) return name;
  }
  return std::nullopt;
}

/// Descends from the scene to where a setting belongs and puts it there.
class Descent {
 public:
  Descent(const Setting& setting, toml::table& root)
      : setting_(setting),
        path_(parse_path(setting.path, setting.place)),
        resolved_(path_),
        node_(&root),
        value_(value_table(setting)) {}

  /// @return the path with the numbers of entries in place of their names.
  Path run() {
    while (at_ + 1 < path_.size()) enter();
    put();
    return resolved_;
  }

 private:
  const std::string* key() const {
    return std::get_if<std::string>(&path_[at_]);
  }
  std::string here() const {
    return at_ == 0 ? "the scene" : text_of(path_, at_);
  }
  Error refusal(std::string_view code, std::string problem,
                std::string remedy) const {
    return {code, setting_.place, std::move(problem), std::move(remedy)};
  }

  /// The number of the entry of a list that the step means.
  std::size_t index_in(const toml::array& list) const {
    if (const auto* number = std::get_if<std::size_t>(&path_[at_])) {
      if (*number < list.size()) return *number;
      throw refusal("S007",
                    fmt::format("{} has {} entries, none of number {}", here(),
                                list.size(), *number),
                    "Numbers count from 0.");
    }
    std::vector<std::string> names;
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < list.size(); ++i) {
      const auto name = name_of(list[i]);
      if (!name) continue;
      names.push_back(*name);
      if (*name == *key()) found.push_back(i);
    }
    if (found.size() == 1) return found[0];
    if (found.size() > 1) {
      throw refusal("S008",
                    fmt::format("{} entries of {} are called \"{:.64}\"",
                                found.size(), here(), *key()),
                    fmt::format("Take one by its number, e.g. {}[{}].", here(),
                                found[0]));
    }
    throw refusal(
        "S007",
        fmt::format("{} has no entry called \"{:.64}\"", here(), *key()),
        names.empty() ? "Take an entry by its number, e.g. [0]."
                      : suggestion(*key(), {names.begin(), names.end()}));
  }

  /// Whether the format has a table of fixed keys here that holds what the
  /// path goes on with.
  bool may_add_table() const {
    if (at_ > 0) return here() != "material";  // else the readers know better
    const auto* next = std::get_if<std::string>(&path_[1]);
    const auto row =
        std::ranges::find(scene_tables(), *key(), &TableKeys::path);
    return next != nullptr && row != scene_tables().end() &&
           std::ranges::find(row->keys, *next) != row->keys.end();
  }

  toml::table& table() const {
    if (auto* found = node_->as_table(); found != nullptr && key() != nullptr) {
      return *found;
    }
    throw refusal("S005",
                  fmt::format("{} is {}, so {} leads nowhere", here(),
                              node_->is_table() ? "a table" : "a value",
                              text_of(path_, at_ + 1)),
                  "Give the path of a value of the scene.");
  }

  void enter() {
    if (auto* list = node_->as_array()) {
      const std::size_t index = index_in(*list);
      node_ = list->get(index);
      resolved_[at_] = index;
    } else {
      toml::table& holder = table();
      if (!holder.contains(*key())) add_table(holder);
      node_ = holder.get(*key());
    }
    ++at_;
  }

  void add_table(toml::table& holder) const {
    if (!may_add_table()) {
      std::vector<std::string_view> known;
      for (const auto& [name, node] : holder) known.push_back(name.str());
      throw refusal(
          "S007", fmt::format("{} has no \"{:.64}\" to enter", here(), *key()),
          suggestion(*key(), known));
    }
    toml::table empty = parsed("{}", setting_.place);
    insert(holder, std::move(*empty.get("v")));
  }

  void insert(toml::table& holder, toml::node&& node) const {
    holder.insert_or_assign(toml::key(*key(), node.source()), std::move(node));
  }

  void put() {
    toml::node&& value = std::move(*value_.get("v"));
    if (auto* list = node_->as_array()) {
      const std::size_t index = index_in(*list);
      resolved_[at_] = index;
      const auto at = list->cbegin() + static_cast<std::ptrdiff_t>(index);
      list->insert(list->erase(at), std::move(value));
    } else {
      insert(table(), std::move(value));
    }
  }

  const Setting& setting_;
  Path path_, resolved_;
  std::size_t at_ = 0;  ///< steps taken
  toml::node* node_;
  toml::table value_;
};

}  // namespace

void apply_settings(const std::vector<Setting>& settings, toml::table& root) {
  struct Put {
    Path path;
    const Setting& setting;
  };
  std::vector<Put> all;
  for (const Setting& setting : settings) {
    const Path path = Descent(setting, root).run();
    for (const Put& earlier : all) {
      // a whole table would undo what was set within it
      if (path.size() > earlier.path.size() ||
          !std::equal(path.begin(), path.end(), earlier.path.begin())) {
        continue;
      }
      throw Error("S010", setting.place,
                  fmt::format("{} is set by {} already, as {}", setting.path,
                              earlier.setting.place, earlier.setting.path),
                  "Give each value once.");
    }
    all.push_back({path, setting});
  }
}

}  // namespace clevis::scene
