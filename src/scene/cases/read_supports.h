#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "part/supports.h"
#include "scene/text/strict_table.h"

namespace clevis::scene {

/// A map from groups of the mesh to what acts on them.
template <typename Content, typename Read>
std::map<std::string, Content> read_groups(StrictTable& table,
                                           std::string_view key, Read read) {
  std::map<std::string, Content> groups;
  const auto value = table.find(key);
  if (!value) return groups;
  for (const auto& [group, entry] : value->entries()) {
    groups.emplace(group, read(entry));
  }
  return groups;
}

/// `fixed` of a case, a history or an impact; empty without.
/// @throws Error S005, S006, S009.
part::Supports read_fixed(StrictTable& table);

/// `foundation` of a case or a history; empty without.
/// @throws Error S004, S005, S006.
part::Foundations read_foundations(StrictTable& table);

/// `held_by_pin` of a case or a history, bores whose pins hold the part; empty
/// without. @param require  throws of a bore that cannot hold.
/// @throws Error S006, S008, S010.
std::vector<std::string> read_held_by_pin(
    StrictTable& table, const std::function<void(const Value&)>& require);

}  // namespace clevis::scene
