#pragma once

#include <string>
#include <utility>
#include <vector>

#include "report/quantities/quantity.h"

namespace clevis::report {

/// A cell of a CSV file under its title, which holds the unit.
struct CsvCell {
  std::string title, text;
};

/// Cells of one quantity: three of a point, none of a row without a column;
/// empty text where the value is not known.
std::vector<CsvCell> csv_cells(const QuantityRow& row, QuantityKind kind,
                               const QuantityValue& value);

/// Cells of a subject, in the order of its rows.
/// @param subject  null: nothing is known of it.
template <class Subject>
void add_csv_cells(const Subject* subject, const Quantities<Subject>& rows,
                   std::vector<CsvCell>& cells) {
  for (const Quantity<Subject>& row : rows) {
    const auto value = subject ? row.get(*subject) : QuantityValue();
    for (CsvCell& cell : csv_cells(row, row.kind, value)) {
      cells.push_back(std::move(cell));
    }
  }
}

/// One line of titles or texts, RFC 4180.
std::string csv_line(const std::vector<CsvCell>& cells,
                     std::string CsvCell::*member);

}  // namespace clevis::report
