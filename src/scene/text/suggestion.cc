#include "scene/text/suggestion.h"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace clevis::scene {
namespace {

/// Levenshtein distance, upper and lower case taken as equal.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  const auto lower = [](char c) {
    return std::tolower(static_cast<unsigned char>(c));
  };
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t substituted =
          diagonal + (lower(a[i]) == lower(b[j]) ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, substituted});
    }
  }
  return row.back();
}

}  // namespace

std::string suggestion(std::string_view name,
                       const std::vector<std::string_view>& known) {
  constexpr std::size_t kMostListed = 20;
  if (known.empty()) return "None is defined.";
  const std::string_view wanted = name.substr(0, 64);
  const auto nearest =
      std::ranges::min_element(known, {}, [&](std::string_view candidate) {
        return edit_distance(wanted, candidate);
      });
  std::string text;
  if (edit_distance(wanted, *nearest) <= 1 + wanted.size() / 2) {
    text = fmt::format("Did you mean \"{}\"? ", *nearest);
  }
  const auto listed =
      std::span(known).first(std::min(known.size(), kMostListed));
  return text + fmt::format("Known: {}{}.", fmt::join(listed, ", "),
                            known.size() > kMostListed ? ", …" : "");
}

}  // namespace clevis::scene
