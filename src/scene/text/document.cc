#include "scene/text/document.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "base/messages/errors.h"

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
  if (!std::filesystem::is_regular_file(status)) {
    throw refuse("is not a regular file",
                 "Give the file itself, not its folder.");
  }
  std::ifstream stream(file, std::ios::binary);
  const std::uintmax_t size = std::filesystem::file_size(file, failure);
  if (!stream || failure) {
    throw refuse("cannot be read", "Check the permissions of the file.");
  }
  if (size > kLargest) {
    throw refuse("is larger than 16 MiB",
                 "It should be a short text; is this another file?");
  }
  return {std::istreambuf_iterator<char>(stream), {}};
}

Document read_document(const std::filesystem::path& file) {
  const std::string text = read_text(file);
  Document document{.file = file.string(), .root = {}};
  refuse_deep_keys(text, document.file);
  try {
    document.root = toml::parse(text, std::string_view(document.file));
  } catch (const toml::parse_error& failure) {
    const auto& at = failure.source().begin;
    throw Error("S001",
                fmt::format("{}:{}:{}", document.file, at.line, at.column),
                std::string(failure.description()),
                "Correct the TOML syntax at this place.");
  }
  return document;
}

}  // namespace clevis::scene
