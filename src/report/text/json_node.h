#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/messages/errors.h"

namespace clevis::report {

/// A value of a stored result that knows its place in the file; what it is not
/// is refused. Numbers are in the units of their keys' names.
/// @throws Error I003.
class JsonNode {
 public:
  JsonNode(const nlohmann::ordered_json& value, std::string place)
      : value_(&value), place_(std::move(place)) {}

  bool has(const char* key) const {
    return value_->is_object() && value_->contains(key) &&
           !value_->at(key).is_null();
  }
  JsonNode at(const char* key) const {
    if (!has(key)) refuse(fmt::format("key \"{}\" is missing", key));
    return {value_->at(key), place_ + "/" + key};
  }
  std::vector<JsonNode> elements() const {
    if (!value_->is_array()) refuse("a list is expected here");
    std::vector<JsonNode> nodes;
    for (std::size_t i = 0; i < value_->size(); ++i) {
      nodes.emplace_back((*value_)[i], fmt::format("{}/{}", place_, i));
    }
    return nodes;
  }
  /// @pre `index` < `size`, of which the list must be.
  JsonNode element(std::size_t index, std::size_t size) const {
    const std::vector<JsonNode> nodes = elements();
    if (nodes.size() != size) refuse(fmt::format("{} are expected", size));
    return nodes[index];
  }
  double number() const {
    if (!value_->is_number()) refuse("a number is expected here");
    return value_->get<double>();
  }
  std::string text() const {
    if (!value_->is_string()) refuse("a text is expected here");
    return value_->get<std::string>();
  }
  bool flag() const {
    if (!value_->is_boolean()) refuse("true or false is expected here");
    return value_->get<bool>();
  }
  template <std::size_t n>
  std::array<double, n> numbers() const {
    const std::vector<JsonNode> nodes = elements();
    if (nodes.size() != n) refuse(fmt::format("{} numbers are expected", n));
    std::array<double, n> values{};
    std::ranges::transform(nodes, values.begin(), &JsonNode::number);
    return values;
  }
  std::map<std::string, std::string> texts() const {
    if (!value_->is_object()) refuse("a table is expected here");
    std::map<std::string, std::string> table;
    for (const auto& [key, value] : value_->items()) {
      table[key] = JsonNode(value, place_ + "/" + key).text();
    }
    return table;
  }

 private:
  [[noreturn]] void refuse(const std::string& problem) const {
    throw Error("I003", place_, problem,
                "Run `clevis check` again, or restore the baseline; "
                "docs/result.schema.json tells what the file must hold.");
  }

  const nlohmann::ordered_json* value_;
  std::string place_;
};

}  // namespace clevis::report
