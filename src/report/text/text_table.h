#pragma once

#include <string>
#include <vector>

#include "report/text/terminal.h"

namespace clevis::report {

enum class Align { kLeft, kRight };

/// Lines of text whose cells stand in aligned columns, two spaces apart.
class TextTable {
 public:
  struct Column {
    std::string title;
    Align align = Align::kLeft;
  };
  struct Cell {
    std::string text;
    Tone tone = Tone::kPlain;
  };

  explicit TextTable(std::vector<Column> columns);

  /// @pre one cell per column.
  void add_row(std::vector<Cell> cells);
  /// A line below the last row that keeps to no column.
  void add_note(std::string text);

  /// All lines; control characters of the cells are made visible.
  std::string text(Colour colour) const;

 private:
  struct Line {
    std::vector<Cell> cells;  ///< empty: a note
    std::string note;
  };
  std::vector<Column> columns_;
  std::vector<Line> lines_;
};

/// Notes as lines below a table, "  note: …".
std::string note_lines(const std::vector<std::string>& notes);

}  // namespace clevis::report
