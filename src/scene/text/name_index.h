#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "scene/text/value.h"

namespace clevis::scene {

/// Names of one kind of entity in the order of the file.
class NameIndex {
 public:
  /// @param kind  singular, for messages: "body".
  explicit NameIndex(std::string kind) : kind_(std::move(kind)) {}

  /// @return index of the new name. @throws Error S008 if there is one.
  int add(const std::string& name, const Value& where);

  /// @return index of `name`. @throws Error S007 with the nearest name.
  int find(const std::string& name, const Value& where) const;

 private:
  std::string kind_;
  std::map<std::string, int, std::less<>> indices_;
};

}  // namespace clevis::scene
