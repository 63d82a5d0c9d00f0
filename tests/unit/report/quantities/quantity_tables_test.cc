#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "report/check/check_quantities.h"
#include "report/machine/bearing_quantities.h"
#include "report/parts/impact_quantities.h"
#include "report/parts/part_quantities.h"
#include "report/parts/peak_quantities.h"
#include "report/parts/probe_quantities.h"
#include "report/summary/mechanism_quantities.h"
#include "support/source_dir.h"

namespace clevis::report {
namespace {

using nlohmann::json;

/// A row without its getter.
struct PlainRow : QuantityRow {
  QuantityKind kind{};
  bool may_lack{};
};

/// The rows of a subject, and where docs/result.schema.json describes it.
struct Table {
  std::string subject;
  std::string schema;  ///< JSON pointer
  std::vector<PlainRow> rows;
};

template <class Subject>
Table table(std::string name, std::string schema,
            const Quantities<Subject>& rows) {
  Table found{std::move(name), std::move(schema), {}};
  for (const auto& row : rows) {
    found.rows.push_back({row, row.kind, row.may_lack});
  }
  return found;
}

std::vector<Table> tables() {
  const std::string part = "/$defs/part";
  const std::string mechanism = "/$defs/mechanism";
  const std::string impact = part + "/properties/impacts/items";
  return {table("check", "", check_quantities()),
          table("mechanism", mechanism, mechanism_quantities()),
          table("joint", mechanism + "/properties/joints/items",
                joint_quantities()),
          table("drive", mechanism + "/properties/drives/items",
                drive_quantities()),
          table("part", part, part_quantities()),
          table("peak", "/$defs/peak", peak_quantities()),
          table("section", "/$defs/support_section", section_quantities()),
          table("impact", impact, blow_quantities()),
          table("model of an impact", impact + "/properties/models/items",
                blow_model_quantities()),
          table("pace", part + "/properties/impact_durations/items",
                duration_ratio_quantities()),
          table("vibration", part + "/properties/vibration",
                vibration_quantities()),
          table("probe", part + "/properties/probes/items", probe_quantities()),
          table("bearing", "/$defs/bearing", bearing_quantities())};
}

TEST(QuantityTables, NamesAndKeysAreUniqueWithinASubject) {
  for (const Table& table : tables()) {
    std::set<std::string> names, keys;
    for (const PlainRow& row : table.rows) {
      EXPECT_TRUE(names.insert(row.name).second) << table.subject << row.name;
      EXPECT_TRUE(keys.insert(row.key).second) << table.subject << row.key;
    }
  }
}

TEST(QuantityTables, TitlesOfPartsCsvAreUnique) {
  std::set<std::string> titles;
  for (const Table& table : tables()) {
    if (table.subject != "part" && table.subject != "impact" &&
        table.subject != "vibration") {
      continue;
    }
    for (const PlainRow& row : table.rows) {
      if (row.column.empty()) continue;
      EXPECT_TRUE(titles.insert(row.column).second) << row.column;
    }
  }
}

// --tolerance names a quantity, not a subject.
TEST(QuantityTables, SameNameHasSameUnitAndToleranceEverywhere) {
  std::map<std::string, PlainRow> first;
  for (const Table& table : tables()) {
    for (const PlainRow& row : table.rows) {
      if (!row.compare) continue;
      const auto& known = first.emplace(row.name, row).first->second;
      EXPECT_EQ(known.unit, row.unit) << table.subject << " " << row.name;
      EXPECT_EQ(known.compare->tolerance, row.compare->tolerance)
          << table.subject << " " << row.name;
    }
  }
}

/// What a key says of its unit: "_mm" of "/at_mm", "_MPa" of
/// "/errors_MPa/mesh".
const std::map<std::string, std::vector<std::string>> kSuffixes = {
    {"MPa", {"_MPa"}},
    {"mm", {"_mm"}},
    {"mJ", {"_mJ"}},
    {"kg", {"_kg"}},
    {"s", {"_s", "seconds"}},
    {"%", {"_percent"}},
    {"deg", {"_deg"}},
    {"h", {"_h"}},
    {"N", {"_N"}},
    {"Nm", {"_Nm", "_N_m"}},
    {"Hz", {"_hz"}},
    {"J", {"_J"}},
    {"m/s", {"_m_per_s"}},
    {"rad/s", {"_rad_per_s"}}};

bool has_suffix(const std::string& key, const std::string& unit) {
  std::istringstream tokens(key.substr(1));
  for (std::string token; std::getline(tokens, token, '/');) {
    for (const std::string& suffix : kSuffixes.at(unit)) {
      if (token.ends_with(suffix)) return true;
    }
  }
  return false;
}

TEST(QuantityTables, KeysNameTheirUnits) {
  for (const Table& table : tables()) {
    for (const PlainRow& row : table.rows) {
      if (row.unit == "1" || row.unit.empty()) {
        for (const auto& [unit, suffixes] : kSuffixes) {
          EXPECT_FALSE(has_suffix(row.key, unit)) << row.key;
        }
      } else {
        EXPECT_TRUE(has_suffix(row.key, row.unit)) << row.key;
      }
      const bool is_number =
          row.kind == QuantityKind::kNumber || row.kind == QuantityKind::kPoint;
      EXPECT_EQ(is_number, !row.unit.empty()) << row.key;
    }
  }
}

json schema() {
  std::ifstream file(support::source_dir() / "docs/result.schema.json");
  return json::parse(file);
}

json resolved(const json& all, const json& node) {
  if (!node.contains("$ref")) return node;
  const auto pointer = node["$ref"].get<std::string>().substr(1);
  return all.at(json::json_pointer(pointer));
}

bool has_type(const json& node, const std::string& type) {
  if (node.contains("enum") || node.contains("const")) return type == "string";
  const json& types = node.at("type");
  return types == type || (types.is_array() &&
                           std::ranges::find(types, json(type)) != types.end());
}

/// A key's place in the schema, and whether it may lack on the way there.
struct Place {
  json node;
  bool may_lack = false;
};

Place place_of(const json& all, const Table& table, const PlainRow& row) {
  Place place{resolved(all, all.at(json::json_pointer(table.schema)))};
  std::istringstream tokens(row.key.substr(1));
  for (std::string token; std::getline(tokens, token, '/');) {
    if (token == "0" || token == "1") {
      place.node = place.node.at("items");
      continue;
    }
    const json required = place.node.value("required", json::array());
    if (std::ranges::find(required, json(token)) == required.end()) {
      place.may_lack = true;
    }
    place.node = resolved(all, place.node.at("properties").at(token));
    if (has_type(place.node, "null")) place.may_lack = true;
  }
  return place;
}

const char* type_of(QuantityKind kind) {
  switch (kind) {
    case QuantityKind::kNumber:
      return "number";
    case QuantityKind::kCount:
      return "integer";
    case QuantityKind::kFlag:
      return "boolean";
    case QuantityKind::kPoint:
      return "array";
    case QuantityKind::kText:
      break;
  }
  return "string";
}

TEST(QuantityTables, SchemaDescribesEveryRow) {
  const json all = schema();
  for (const Table& table : tables()) {
    for (const PlainRow& row : table.rows) {
      const Place place = place_of(all, table, row);
      EXPECT_TRUE(has_type(place.node, type_of(row.kind)))
          << table.subject << row.key;
      if (row.may_lack) {
        EXPECT_TRUE(place.may_lack) << table.subject << row.key;
      }
    }
  }
}

// Else `compare` would refuse a file that the schema allows.
TEST(QuantityTables, WhatCompareCannotDoWithoutIsRequired) {
  const json all = schema();
  for (const Table& table : tables()) {
    if (table.subject == "vibration") continue;  // or a `failure` alone
    for (const PlainRow& row : table.rows) {
      if (!row.compare || row.may_lack || row.since == Since::kLater) continue;
      EXPECT_FALSE(place_of(all, table, row).may_lack)
          << table.subject << row.key;
    }
  }
}

/// Keys of scalars below a node, lists left out but of numbers.
void collect(const json& all, const json& node, const std::string& key,
             std::set<std::string>& keys) {
  const json here = resolved(all, node);
  if (here.contains("properties")) {
    for (const auto& [name, child] : here["properties"].items()) {
      collect(all, child, key + "/" + name, keys);
    }
  } else if (here.contains("items")) {
    const json items = resolved(all, here["items"]);
    if (!has_type(items, "number")) return;
    if (here.value("maxItems", 0) == 2) {
      keys.insert(key + "/0");
      keys.insert(key + "/1");
    } else {
      keys.insert(key);
    }
  } else {
    keys.insert(key);
  }
}

TEST(QuantityTables, EveryScalarThatTheSchemaGivesAPartHasARow) {
  const json all = schema();
  for (const Table& table : tables()) {
    if (table.schema.empty()) continue;
    std::set<std::string> keys;
    collect(all, all.at(json::json_pointer(table.schema)), "", keys);
    for (const PlainRow& row : table.rows) keys.erase(row.key);
    for (const std::string& key : keys) {
      // of the scene; of tables of their own
      const bool is_elsewhere =
          key.starts_with("/limits/") || key.starts_with("/vibration/") ||
          key.starts_with("/peak_outside_singular_zones/") ||
          key == "/failure" || key == "/not_followed" ||
          (table.subject == "pace" && key == "/first_period_s");
      EXPECT_TRUE(is_elsewhere) << table.subject << key;
    }
  }
}

/// Row of docs/results.md by quantity.
std::map<std::string, std::string> manual_rows() {
  std::ifstream file(support::source_dir() / "docs/results.md");
  std::map<std::string, std::string> rows;
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("| `")) continue;
    const std::string names = line.substr(0, line.find(" | "));
    std::istringstream parts(names);
    for (std::string part; std::getline(parts, part, '`');) {
      if (part != "| " && part != ", ") rows.emplace(part, line);
    }
  }
  return rows;
}

TEST(QuantityTables, ManualSaysWhoseQuantityIsCompared) {
  const auto manual = manual_rows();
  for (const Table& table : tables()) {
    if (table.subject == "peak" || table.subject == "section") continue;
    for (const PlainRow& row : table.rows) {
      if (!row.compare) continue;
      const auto found = manual.find(row.name);
      ASSERT_NE(found, manual.end()) << row.name;
      const auto from = found->second.find(" | ") + 3;
      const std::string of =
          found->second.substr(from, found->second.find(" | ", from) - from);
      EXPECT_NE(of.find(table.subject), std::string::npos)
          << row.name << " of " << table.subject << ": " << of;
    }
  }
}

}  // namespace
}  // namespace clevis::report
