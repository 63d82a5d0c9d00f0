#include "scene/csv/csv_text.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "base/messages/errors.h"

namespace clevis::scene {
namespace {

/// Reads from the start of a text to its end and counts lines.
class CsvReader {
 public:
  CsvReader(std::string_view text, const std::string& file)
      : text_(text), file_(file) {
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
    if (text_.starts_with(kByteOrderMark)) {
      text_.remove_prefix(kByteOrderMark.size());
    }
  }

  bool at_end() const { return at_ == text_.size(); }

  /// The fields of a line; of an empty one none.
  std::vector<CsvField> row() {
    std::vector<CsvField> fields;
    if (take_line_end()) return fields;
    fields.push_back(field());
    while (!at_end() && !take_line_end()) {
      ++at_;  // the comma behind a field
      fields.push_back(field());
    }
    return fields;
  }

 private:
  std::string place() const {
    return fmt::format("{}:{}:{}", file_, line_, at_ - line_start_ + 1);
  }
  Error refusal(const char* problem) const {
    return {"S012", place(), problem,
            "Write a field that holds commas, quotes or line ends in double "
            "quotes, and a quote in it twice."};
  }

  bool take_line_end() {
    const std::string_view rest = text_.substr(at_);
    const std::size_t length = rest.starts_with("\r\n") ? 2
                               : rest.starts_with('\n') ? 1
                                                        : 0;
    at_ += length;
    if (length > 0) begin_line();
    return length > 0;
  }
  void begin_line() {
    ++line_;
    line_start_ = at_;
  }

  CsvField field() {
    CsvField field{"", place()};
    if (text_.substr(at_).starts_with('"')) {
      field.text = quoted();
    } else {
      const std::size_t end =
          std::min(text_.find_first_of(",\"\r\n", at_), text_.size());
      field.text = text_.substr(at_, end - at_);
      at_ = end;
    }
    const std::string_view rest = text_.substr(at_);
    if (!rest.empty() && !rest.starts_with(',') && !rest.starts_with('\n') &&
        !rest.starts_with("\r\n")) {
      throw refusal("a quote or a carriage return stands within a field");
    }
    return field;
  }

  std::string quoted() {
    std::string content;
    const Error open = refusal("this quote is not closed");
    for (++at_; at_ < text_.size(); ++at_) {
      if (text_[at_] == '"') {
        ++at_;
        if (!text_.substr(at_).starts_with('"')) return content;
      }
      content += text_[at_];
      if (text_[at_] == '\n') {
        ++line_;
        line_start_ = at_ + 1;
      }
    }
    throw open;
  }

  std::string_view text_;
  std::string file_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  std::size_t line_start_ = 0;
};

/// A header that other separators than commas keep in one field.
void refuse_other_separators(const std::vector<CsvField>& header) {
  if (header.size() != 1) return;
  for (const auto& [separator, name] :
       {std::pair{';', "semicolons"}, std::pair{'\t', "tabs"}}) {
    if (header.front().text.find(separator) == std::string::npos) continue;
    throw Error("S012", header.front().place,
                fmt::format("{} separate the columns, commas are wanted", name),
                fmt::format("Replace decimal commas, if there are any, by "
                            "points; then all {} by commas.",
                            name));
  }
}

}  // namespace

std::vector<std::vector<CsvField>> parse_csv(std::string_view text,
                                             const std::string& file) {
  CsvReader reader(text, file);
  std::vector<std::vector<CsvField>> rows;
  while (!reader.at_end()) {
    auto row = reader.row();
    if (row.empty()) continue;
    if (rows.empty()) refuse_other_separators(row);
    if (!rows.empty() && row.size() != rows.front().size()) {
      throw Error("S012", row.front().place,
                  fmt::format("the row has {} fields, the header {}",
                              row.size(), rows.front().size()),
                  "Give every row as many fields as the header.");
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace clevis::scene
