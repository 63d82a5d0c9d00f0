#include "scene/variants/key_path.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include <fmt/format.h>

#include "base/messages/errors.h"

namespace clevis::scene {
namespace {

constexpr std::size_t kMostSteps = 16;

bool is_bare(char c) {
  constexpr std::string_view kBare =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-";
  return kBare.find(c) != kBare.npos;
}

/// A step that is a number in square brackets; takes it from the text.
std::optional<PathStep> take_index(std::string_view& text) {
  if (!text.starts_with('[')) return std::nullopt;
  std::size_t number = 0;
  const char* end = text.data() + text.size();
  const auto [at, failure] = std::from_chars(text.data() + 1, end, number);
  if (failure != std::errc{} || at == end || *at != ']') return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(at - text.data()) + 1);
  return number;
}

/// A key, bare or in double quotes; takes it from the text.
std::optional<PathStep> take_key(std::string_view& text) {
  if (text.starts_with('"')) {
    const std::size_t end = text.find('"', 1);
    if (end == text.npos || end == 1) return std::nullopt;
    std::string key(text.substr(1, end - 1));
    text.remove_prefix(end + 1);
    return key;
  }
  const auto end = std::ranges::find_if_not(text, is_bare);
  const auto length = static_cast<std::size_t>(end - text.begin());
  if (length == 0) return std::nullopt;
  std::string key(text.substr(0, length));
  text.remove_prefix(length);
  return key;
}

}  // namespace

std::vector<PathStep> parse_path(std::string_view text,
                                 const std::string& place) {
  std::string_view rest = text;
  std::vector<PathStep> path;
  do {
    auto step = path.empty() ? take_key(rest) : take_index(rest);
    if (!step && rest.starts_with('.')) {
      rest.remove_prefix(1);
      step = take_key(rest);
    }
    if (!step || path.size() == kMostSteps) {
      throw Error("S007", place,
                  fmt::format("{:?} is no path to a value of the scene",
                              text.substr(0, 80)),
                  "Write keys and names with dots between them and numbers in "
                  "brackets, e.g. part.AB.thickness or joint.B.at.AB[0]; names "
                  "with dots in double quotes.");
    }
    path.push_back(*step);
  } while (!rest.empty());
  return path;
}

std::string text_of(const std::vector<PathStep>& path, std::size_t steps) {
  std::string text;
  for (std::size_t i = 0; i < std::min(steps, path.size()); ++i) {
    if (const auto* number = std::get_if<std::size_t>(&path[i])) {
      text += fmt::format("[{}]", *number);
      continue;
    }
    const auto& key = std::get<std::string>(path[i]);
    if (i > 0) text += '.';
    text +=
        std::ranges::all_of(key, is_bare) ? key : fmt::format("\"{}\"", key);
  }
  return text;
}

}  // namespace clevis::scene
