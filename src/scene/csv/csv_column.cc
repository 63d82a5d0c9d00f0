#include "scene/csv/csv_column.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/messages/errors.h"

namespace clevis::scene {
namespace {

CsvColumn column_of(const CsvField& field) {
  CsvColumn column{field.text, "", field.place};
  const std::size_t bracket = field.text.rfind(" [");
  if (bracket != std::string::npos && field.text.ends_with(']')) {
    column.name = field.text.substr(0, bracket);
    column.unit =
        field.text.substr(bracket + 2, field.text.size() - bracket - 3);
  }
  return column;
}

}  // namespace

std::vector<CsvColumn> csv_columns(const std::vector<CsvField>& header) {
  std::vector<CsvColumn> columns;
  for (const CsvField& field : header) {
    CsvColumn column = column_of(field);
    if (std::ranges::find(columns, column.name, &CsvColumn::name) !=
        columns.end()) {
      throw Error("S012", field.place,
                  fmt::format("the column {:?} stands there twice",
                              field.text.substr(0, 80)),
                  "Give each value one column.");
    }
    columns.push_back(std::move(column));
  }
  return columns;
}

}  // namespace clevis::scene
