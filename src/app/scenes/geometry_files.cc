#include "app/scenes/geometry_files.h"

#include <array>
#include <cctype>
#include <fstream>
#include <iterator>
#include <set>
#include <string_view>
#include <vector>

namespace clevis::app {
namespace {

namespace fs = std::filesystem;

std::string read_file(const fs::path& file) {
  std::error_code failure;
  if (!fs::is_regular_file(file, failure)) return {};
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// The name in quotes behind a command at `at`, blanks and one bracket between
/// them; empty if something else stands there.
std::string_view name_behind(std::string_view text, std::size_t at) {
  at = text.find_first_not_of(" \t\r\n", at);
  if (at < text.size() && text[at] == '(') {
    at = text.find_first_not_of(" \t\r\n", at + 1);
  }
  if (at >= text.size() || text[at] != '"') return {};
  const std::size_t end = text.find('"', at + 1);
  return end == text.npos ? "" : text.substr(at + 1, end - at - 1);
}

/// In the order of the text; those in comments too, which do no harm.
std::vector<std::string> names_in(std::string_view text) {
  constexpr std::array<std::string_view, 4> kCommands{
      "Merge", "MergeFile", "Include", "ShapeFromFile"};
  std::vector<std::string> names;
  for (std::size_t i = 0; i < text.size();) {
    if (!is_word(text[i])) {
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < text.size() && is_word(text[end])) ++end;
    for (const auto command : kCommands) {
      if (text.substr(i, end - i) != command) continue;
      const auto name = name_behind(text, end);
      if (!name.empty()) names.emplace_back(name);
    }
    i = end;
  }
  return names;
}

void add(const fs::path& file, std::set<fs::path>& seen,
         std::vector<fs::path>& all) {
  if (!seen.insert(fs::absolute(file).lexically_normal()).second) return;
  all.push_back(file);
  if (file.extension() != ".geo") return;
  for (const std::string& name : names_in(read_file(file))) {
    add(file.parent_path() / name, seen, all);
  }
}

}  // namespace

std::vector<fs::path> geometry_files(const fs::path& geometry) {
  std::set<fs::path> seen;
  std::vector<fs::path> all;
  add(geometry, seen, all);
  return all;
}

std::string geometry_content(const fs::path& geometry) {
  std::string all;
  for (const fs::path& file : geometry_files(geometry)) {
    if (file != geometry) all += '\0';
    all += read_file(file);
  }
  return all;
}

}  // namespace clevis::app
