#include "report/text/text_table.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include <fmt/format.h>

#include "report/text/terminal.h"

namespace clevis::report {
namespace {

/// Places on the terminal: every character of UTF-8 takes one ("µ", "·").
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
  }));
}

void trim_end(std::string& line) {
  line.erase(line.find_last_not_of(' ') + 1);
}

}  // namespace

TextTable::TextTable(std::vector<Column> columns)
    : columns_(std::move(columns)) {}

void TextTable::add_row(std::vector<Cell> cells) {
  assert(cells.size() == columns_.size() && "one cell per column");
  for (Cell& cell : cells) cell.text = printable(cell.text);
  lines_.push_back({std::move(cells), {}});
}

void TextTable::add_note(std::string text) {
  lines_.push_back({{}, "    " + printable(text)});
}

std::string TextTable::text(Colour colour) const {
  std::vector<std::size_t> widths;
  Line header;
  for (const Column& column : columns_) {
    widths.push_back(width(column.title));
    header.cells.push_back({column.title});
  }
  for (const Line& line : lines_) {
    for (std::size_t i = 0; i < line.cells.size(); ++i) {
      widths[i] = std::max(widths[i], width(line.cells[i].text));
    }
  }
  std::string all;
  const auto append = [&](const Line& line) {
    std::string text = line.note;
    for (std::size_t i = 0; i < line.cells.size(); ++i) {
      const Cell& cell = line.cells[i];
      const std::string blank(widths[i] - width(cell.text), ' ');
      const std::string painted = paint(cell.text, cell.tone, colour);
      if (i > 0) text += "  ";
      text += columns_[i].align == Align::kRight ? blank + painted
                                                 : painted + blank;
    }
    trim_end(text);
    all += text + "\n";
  };
  append(header);
  std::ranges::for_each(lines_, append);
  return all;
}

std::string note_lines(const std::vector<std::string>& notes) {
  std::string text;
  for (const std::string& note : notes) {
    text += printable(fmt::format("  note: {}", note)) + "\n";
  }
  return text;
}

}  // namespace clevis::report
