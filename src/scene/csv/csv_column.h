#pragma once

#include <string>
#include <vector>

#include "scene/csv/csv_text.h"

namespace clevis::scene {

/// Title of a column: a name, and behind it in brackets the unit of its
/// fields, "AB.force_x [N]".
struct CsvColumn {
  std::string name;
  std::string unit;   ///< empty: none is given
  std::string place;  ///< file:line:column
};

/// Columns of a header row. @throws Error S012 if two have one name.
std::vector<CsvColumn> csv_columns(const std::vector<CsvField>& header);

}  // namespace clevis::scene
