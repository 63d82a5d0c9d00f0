#include "report/quantities/quantity_csv.h"

#include <fmt/format.h>

#include "report/text/csv_field.h"

namespace clevis::report {
namespace {

struct ToText {
  std::string_view unit;

  std::string operator()(double value) const {
    return fmt::format("{}", in_unit(value, unit));
  }
  std::string operator()(int count) const { return std::to_string(count); }
  std::string operator()(bool flag) const { return flag ? "yes" : "no"; }
  std::string operator()(const std::string& text) const { return text; }
  template <class T>
  std::string operator()(const T&) const {
    return {};
  }
};

std::vector<CsvCell> point_cells(const QuantityRow& row,
                                 const QuantityValue& value) {
  std::vector<CsvCell> cells;
  for (const int axis : {0, 1, 2}) {
    const auto* point = std::get_if<Eigen::Vector3d>(&value);
    cells.push_back(
        {fmt::format("{}_{}[{}]", row.column, "xyz"[axis], row.unit),
         point ? ToText{row.unit}((*point)[axis]) : std::string()});
  }
  return cells;
}

}  // namespace

std::vector<CsvCell> csv_cells(const QuantityRow& row, QuantityKind kind,
                               const QuantityValue& value) {
  if (row.column.empty()) return {};
  if (kind == QuantityKind::kPoint) return point_cells(row, value);
  return {{row.unit.empty() ? row.column
                            : fmt::format("{}[{}]", row.column, row.unit),
           std::visit(ToText{row.unit}, value)}};
}

std::string csv_line(const std::vector<CsvCell>& cells,
                     std::string CsvCell::*member) {
  std::string line;
  for (const CsvCell& cell : cells) {
    if (&cell != &cells.front()) line += ",";
    line += csv_field(cell.*member);
  }
  return line + "\r\n";
}

}  // namespace clevis::report
