#include "support/json_schema.h"

#include <algorithm>
#include <set>

namespace clevis::test_support {
namespace {

using nlohmann::json;

bool has_type(const json& value, const std::string& type) {
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "integer") return value.is_number_integer();
  if (type == "number") return value.is_number();
  return type == "null" && value.is_null();
}

class Checker {
 public:
  explicit Checker(const json& root) : root_(root) {}

  void check(const json& value, const json& rule, const std::string& place) {
    for (const auto& [keyword, wanted] : rule.items()) {
      if (keyword == "$ref") {
        const std::string target = wanted.get<std::string>().substr(1);
        check(value, root_.at(json::json_pointer(target)), place);
      } else if (keyword == "type") {
        check_type(value, wanted, place);
      } else if (keyword == "const") {
        expect(value == wanted, place + ": is not " + wanted.dump());
      } else if (keyword == "enum") {
        expect(std::ranges::find(wanted, value) != wanted.end(),
               place + ": is none of " + wanted.dump());
      } else if (keyword == "minimum") {
        expect(!value.is_number() || value >= wanted, place + ": too small");
      } else if (keyword == "minItems") {
        expect(!value.is_array() || value.size() >= wanted,
               place + ": too short");
      } else if (keyword == "maxItems") {
        expect(value.size() <= wanted, place + ": too long");
      } else if (keyword == "items") {
        check_items(value, wanted, place);
      } else if (keyword == "required") {
        check_required(value, wanted, place);
      } else if (keyword == "properties") {
        check_properties(value, rule, place);
      } else if (keyword == "additionalProperties") {
        check_additional(value, rule, place);
      } else if (!kDescriptive.contains(keyword)) {
        errors_.push_back("schema keyword " + keyword + " is not checked");
      }
    }
  }

  std::vector<std::string> errors() const { return errors_; }

 private:
  inline static const std::set<std::string> kDescriptive = {
      "$schema", "$defs", "title", "description"};

  void expect(bool holds, const std::string& otherwise) {
    if (!holds) errors_.push_back(otherwise);
  }
  void check_type(const json& value, const json& types,
                  const std::string& place) {
    const json list = types.is_array() ? types : json::array({types});
    const bool fits = std::ranges::any_of(list, [&](const json& type) {
      return has_type(value, type);
    });
    expect(fits, place + ": is not of type " + types.dump());
  }
  void check_items(const json& value, const json& rule,
                   const std::string& place) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      check(value[i], rule, place + "/" + std::to_string(i));
    }
  }
  void check_required(const json& value, const json& keys,
                      const std::string& place) {
    if (!value.is_object()) return;  // that is the type's matter
    for (const std::string key : keys) {
      expect(value.contains(key), place + "/" + key + ": is missing");
    }
  }
  void check_properties(const json& value, const json& rule,
                        const std::string& place) {
    for (const auto& [key, property] : rule["properties"].items()) {
      if (value.contains(key)) check(value[key], property, place + "/" + key);
    }
  }
  void check_additional(const json& value, const json& rule,
                        const std::string& place) {
    const json& additional = rule["additionalProperties"];
    for (const auto& [key, member] : value.items()) {
      if (rule.contains("properties") && rule["properties"].contains(key)) {
        continue;
      }
      if (additional.is_boolean()) {
        expect(additional.get<bool>(), place + "/" + key + ": undeclared");
      } else {
        check(member, additional, place + "/" + key);
      }
    }
  }

  const json& root_;
  std::vector<std::string> errors_;
};

}  // namespace

std::vector<std::string> schema_errors(const json& document,
                                       const json& schema) {
  Checker checker(schema);
  checker.check(document, schema, "");
  return checker.errors();
}

}  // namespace clevis::test_support
