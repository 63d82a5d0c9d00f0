#include "scene/text/name_index.h"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "scene/text/suggestion.h"

namespace clevis::scene {

int NameIndex::add(const std::string& name, const Value& where) {
  const auto [entry, is_new] =
      indices_.try_emplace(name, static_cast<int>(indices_.size()));
  if (!is_new) {
    throw Error("S008", where.place(),
                fmt::format("the {} \"{}\" is defined twice", kind_, name),
                "Give each its own name.");
  }
  return entry->second;
}

int NameIndex::find(const std::string& name, const Value& where) const {
  const auto found = indices_.find(name);
  if (found != indices_.end()) return found->second;
  std::vector<std::string_view> known;
  for (const auto& [known_name, index] : indices_) known.push_back(known_name);
  throw where.refusal("S007",
                      fmt::format("names no {}: \"{:.64}\"", kind_, name),
                      suggestion(name, known));
}

}  // namespace clevis::scene
