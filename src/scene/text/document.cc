#include "scene/text/document.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "base/messages/errors.h"
#include "part/solid_source.h"

namespace clevis::scene {
namespace {

/// Dots of the line's longest dotted key, at least. Texts and the numbers of a
/// list have dots of their own, apart from keys; a line that may lie in a text
/// of several lines counts whole.
std::ptrdiff_t dots_of_a_key(std::string_view line) {
  if (line.find(R"(""")") != line.npos || line.find("'''") != line.npos) {
    return std::ranges::count(line, '.');
  }
  std::ptrdiff_t most = 0, dots = 0;
  char quote = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quote) {
      if (c == '\\' && quote == '"') ++i;
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '#') {
      break;
    } else if (std::string_view("=,[]{}").find(c) != std::string_view::npos) {
      dots = 0;
    } else if (c == '.') {
      most = std::max(most, ++dots);
    }
  }
  return quote ? std::ranges::count(line, '.') : most;
}

/// toml++ 3.3 overflows the stack on keys of some 30 000 dotted levels
/// (a.a.a…); it limits nested values to 256 but not dotted keys. With 64 dots
/// in a key at most, the depth stays below 64 · 256.
void refuse_deep_keys(std::string_view text, const std::string& file) {
  constexpr std::ptrdiff_t kMostDots = 64;
  int number = 1;
  for (std::size_t start = 0; start < text.size(); ++number) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    if (dots_of_a_key(text.substr(start, end - start)) > kMostDots) {
      throw Error("S001", fmt::format("{}:{}:1", file, number),
                  "a key has more than 64 dots",
                  "Keys nest three levels at most.");
    }
    start = end + 1;
  }
}

/// Offset of a place whose line and column (in characters) count from 1.
std::size_t offset_of(std::string_view text, const toml::source_position& at) {
  std::size_t offset = 0;
  for (toml::source_index line = 1; line < at.line; ++line) {
    offset = std::min(text.find('\n', offset), text.size() - 1) + 1;
  }
  const auto continues = [&] {
    return offset < text.size() &&
           (static_cast<unsigned char>(text[offset]) & 0xC0u) == 0x80u;
  };
  for (toml::source_index c = 1; c < at.column && offset < text.size(); ++c) {
    do {
      ++offset;
    } while (continues());
  }
  return offset;
}

/// What stands around an offset where TOML wants a value, without typographic
/// quotation marks; empty if it is quoted, or a name.
std::string bare_value(std::string_view text, std::size_t offset) {
  constexpr std::string_view kBorders = "=,[]{}\"'#";
  constexpr std::array<std::string_view, 8> kTypographic{"“", "”", "„", "‘",
                                                         "’", "‚", "«", "»"};
  const std::size_t border = text.substr(0, offset).find_last_of(kBorders);
  if (border == text.npos ||
      (text[border] != '=' && text[border] != ',' && text[border] != '[')) {
    return "";
  }
  const std::size_t line = text.substr(0, border).rfind('\n') + 1;  // npos + 1
  const std::string_view before = text.substr(line, border + 1 - line);
  if (before.find_first_not_of(" \t[") == before.npos) return "";  // a header
  const std::size_t start = text.find_first_not_of(
      text[border] == '=' ? " \t" : " \t\r\n", border + 1);
  const std::size_t end =
      std::min(text.find_first_of("=,[]{}\"'#\r\n", start), text.size());
  if (start == text.npos || offset > end) return "";
  std::string value(text.substr(start, end - start));
  for (const std::string_view mark : kTypographic) {
    for (std::size_t at = 0; (at = value.find(mark)) != value.npos;) {
      value.erase(at, mark.size());
    }
  }
  value.erase(value.find_last_not_of(" \t") + 1);
  return value;
}

/// Whether a text, or a quantity with its unit, rather than a number.
bool is_wordy(std::string_view value) {
  const auto is_of_words = [](unsigned char c) {
    return std::isalpha(c) != 0 || c == '%' || c >= 0x80u;
  };
  const auto is_control = [](unsigned char c) {
    return std::iscntrl(c) != 0;
  };
  return std::ranges::any_of(value, is_of_words) &&
         std::ranges::none_of(value, is_control);
}

struct Slip {
  std::string problem, remedy;
};

/// What a newcomer to TOML may have meant where its parser gives up.
Slip slip(std::string_view text, const toml::parse_error& failure) {
  const std::size_t offset = offset_of(text, failure.source().begin);
  const std::string_view description = failure.description();
  const std::string_view rest = text.substr(std::min(offset, text.size()));
  constexpr std::size_t kLongest = 60;
  const std::string value = bare_value(text, offset);
  const auto is_digit = [](char c) {
    return '0' <= c && c <= '9';
  };
  if (value.size() <= kLongest && is_wordy(value)) {
    return {fmt::format("{} stands without quotation marks", value),
            fmt::format("Write texts, and numbers with their unit, in straight "
                        "double quotes: \"{}\".",
                        value)};
  }
  if (rest.size() > 1 && rest[0] == ',' && is_digit(rest[1]) && offset > 0 &&
      is_digit(text[offset - 1])) {
    return {"a comma stands where a decimal point belongs",
            "Write numbers with a decimal point."};
  }
  if (description.find("string: ") != description.npos &&
      (rest.empty() || rest[0] == '\n' || rest[0] == '\r')) {
    return {"the text is not closed before the line ends",
            "End it with the quotation mark that it begins with."};
  }
  if (description.find("escape") != description.npos ||
      description.find("unicode scalar") != description.npos) {
    return {"a backslash stands in a text",
            "Write paths with /; any other backslash twice."};
  }
  return {std::string(description), "Correct the TOML syntax at this place."};
}

/// Refuses files of other kinds, which a parser of TOML would take for a
/// faulty scene.
void refuse_other_kinds(const std::filesystem::path& file) {
  const std::string extension = file.extension().string();
  const auto refuse = [&](const char* kind, const std::string& remedy) {
    return Error("S001", file.string() + ":1:1",
                 fmt::format("is {}, not a scene", kind), remedy);
  };
  const std::string name = file.filename().string();
  if (part::is_solid_file(file)) {
    throw refuse(
        "a CAD file",
        fmt::format("Make a scene of it: clevis init NAME --geometry {}; or "
                    "give one (TOML) whose [[part]] has geometry = {:?}.",
                    file.string(), name));
  }
  if (extension == ".geo" || extension == ".msh") {
    throw refuse(
        "a file of gmsh",
        fmt::format("Give a scene (TOML) whose [[part]] has {} = {:?}: `clevis "
                    "init NAME` writes one to start from.",
                    extension == ".geo" ? "geometry" : "mesh", name));
  }
  if (extension == ".sdf" || extension == ".urdf") {
    throw refuse("a model of another program",
                 "Make a scene of it: clevis import " + file.string() + ".");
  }
}

}  // namespace

std::string read_text(const std::filesystem::path& file) {
  constexpr std::uintmax_t kLargest = 16u << 20;  // bytes; parses in 1 s
  const auto refuse = [&](const char* problem, const char* remedy) {
    return Error("I001", file.string(), problem, remedy);
  };
  std::error_code failure;
  const auto status = std::filesystem::status(file, failure);
  if (!std::filesystem::exists(status)) {
    throw refuse("there is no such file", "Check the path.");
  }
  if (std::filesystem::is_directory(status)) {
    throw Error(
        "I001", file.string(), "is a folder, not a file",
        std::filesystem::exists(file / "scene.toml", failure)
            ? "Give the scene in it: " + (file / "scene.toml").string() + "."
            : "Give the file itself.");
  }
  if (!std::filesystem::is_regular_file(status)) {
    throw refuse("is not a regular file", "Give the path of a file.");
  }
  std::ifstream stream(file, std::ios::binary);
  const std::uintmax_t size = std::filesystem::file_size(file, failure);
  if (!stream || failure) {
    throw refuse("cannot be read", "Check the permissions of the file.");
  }
  if (size > kLargest) {
    throw refuse(
        "is larger than 16 MiB",
        "Leave rows of a table out that change nothing, or check whether "
        "this is another file.");
  }
  return {std::istreambuf_iterator<char>(stream), {}};
}

Document read_document(const std::filesystem::path& file) {
  const std::string text = read_text(file);
  refuse_other_kinds(file);
  Document document{.file = file.string(), .root = {}};
  refuse_deep_keys(text, document.file);
  try {
    document.root = toml::parse(text, std::string_view(document.file));
  } catch (const toml::parse_error& failure) {
    const auto& at = failure.source().begin;
    const auto [problem, remedy] = slip(text, failure);
    throw Error("S001",
                fmt::format("{}:{}:{}", document.file, at.line, at.column),
                problem, remedy);
  }
  return document;
}

}  // namespace clevis::scene
