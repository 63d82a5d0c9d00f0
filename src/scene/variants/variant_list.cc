#include "scene/variants/variant_list.h"

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "base/messages/errors.h"
#include "scene/csv/csv_column.h"
#include "scene/csv/csv_text.h"
#include "scene/text/document.h"
#include "scene/text/value.h"
#include "scene/variants/key_path.h"

namespace clevis::scene {
namespace {

bool is_name_column(const CsvColumn& column) {
  return column.name == "variant";
}

/// The columns of a table of variants; "variant" holds their names.
std::vector<CsvColumn> path_columns(const std::vector<CsvField>& header) {
  std::vector<CsvColumn> columns = csv_columns(header);
  for (const CsvColumn& column : columns) {
    if (!is_name_column(column)) parse_path(column.name, column.place);
  }
  return columns;
}

std::string variant_name(const CsvField& field,
                         std::map<std::string, std::string>& places) {
  if (!is_name(field.text) || field.text.find('.') != std::string::npos) {
    throw Error("S006", field.place,
                fmt::format("{:?} cannot be the name of a variant",
                            field.text.substr(0, 80)),
                "Names have 1 to 64 of the characters A-Z a-z 0-9 _ - and do "
                "not start with -, because folders are named after them.");
  }
  const auto [first, is_new] = places.emplace(field.text, field.place);
  if (!is_new) {
    throw Error("S008", field.place,
                fmt::format("the variant \"{}\" stands at {} already",
                            field.text, first->second),
                "Give each its own name.");
  }
  return field.text;
}

Setting setting_of(const CsvColumn& column, const CsvField& field) {
  if (field.text.find_first_not_of(' ') == std::string::npos) {
    throw Error("S012", field.place, "the field is empty",
                "Give every variant a value in every column.");
  }
  const std::string unit = column.unit.empty() ? "" : " " + column.unit;
  return {column.name, field.text + unit, field.place};
}

}  // namespace

std::vector<Variant> read_variant_list(const std::filesystem::path& file) {
  const auto rows = parse_csv(read_text(file), file.string());
  if (rows.size() < 2) {
    throw Error("S012", file.string() + ":1:1",
                rows.empty() ? "the table is empty" : "the table has no row",
                "Write a header of paths, and a row for each variant.");
  }
  const std::vector<CsvColumn> columns = path_columns(rows.front());
  std::map<std::string, std::string> places;
  std::vector<Variant> variants;
  for (std::size_t r = 1; r < rows.size(); ++r) {
    Variant variant{numbered_name(r, rows.size() - 1), {}};
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (is_name_column(columns[c])) {
        variant.name = variant_name(rows[r][c], places);
      } else {
        variant.settings.push_back(setting_of(columns[c], rows[r][c]));
      }
    }
    variants.push_back(std::move(variant));
  }
  return variants;
}

}  // namespace clevis::scene
