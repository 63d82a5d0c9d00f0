#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace clevis::scene {

/// A field of a table and where it starts.
struct CsvField {
  std::string text;
  std::string place;  ///< file:line:column, columns counted in bytes
};

/// The rows of an RFC 4180 text: fields between commas, those in double quotes
/// with commas, line ends and doubled quotes in them. LF alone ends a line
/// too; empty lines and a byte order mark are left out.
/// @param file  for places.
/// @throws Error S012 if a quote is not closed or stands within a field, if a
///   row has more or fewer fields than the first, or if semicolons or tabs
///   separate the columns.
std::vector<std::vector<CsvField>> parse_csv(std::string_view text,
                                             const std::string& file);

}  // namespace clevis::scene
