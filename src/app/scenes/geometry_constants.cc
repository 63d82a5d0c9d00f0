#include "app/scenes/geometry_constants.h"

#include <algorithm>
#include <cctype>
#include <vector>

#include <fmt/format.h>

#include "app/scenes/geometry_files.h"
#include "base/messages/errors.h"
#include "scene/text/suggestion.h"

namespace clevis::app {
namespace {

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Words and signs of a .geo; a text is one empty token.
std::vector<std::string_view> tokens_of(std::string_view text) {
  std::vector<std::string_view> tokens;
  std::size_t at = 0;
  const auto skip_to = [&](std::string_view end, std::size_t from) {
    const std::size_t found = text.find(end, from);
    at = found == text.npos ? text.size() : found + end.size();
  };
  while (at < text.size()) {
    const std::string_view rest = text.substr(at);
    if (rest.starts_with("//")) {
      skip_to("\n", at);
    } else if (rest.starts_with("/*")) {
      skip_to("*/", at + 2);
    } else if (rest.front() == '"') {
      skip_to("\"", at + 1);
      tokens.emplace_back();
    } else if (is_word(rest.front())) {
      const auto length = static_cast<std::size_t>(
          std::ranges::find_if_not(rest, is_word) - rest.begin());
      tokens.push_back(rest.substr(0, length));
      at += length;
    } else {
      constexpr std::string_view kBlanks{" \t\r\n\0", 5};
      if (kBlanks.find(rest.front()) == kBlanks.npos) {
        tokens.push_back(rest.substr(0, 1));
      }
      ++at;
    }
  }
  return tokens;
}

bool opens(std::string_view token) {
  return token == "[" || token == "(" || token == "{";
}

bool closes(std::string_view token) {
  return token == "]" || token == ")" || token == "}";
}

/// Whether the token after a word makes it the target of an assignment.
bool is_assignment(const std::vector<std::string_view>& tokens,
                   std::size_t sign) {
  const auto at = [&](std::size_t i) {
    return i < tokens.size() ? tokens[i] : std::string_view();
  };
  constexpr std::string_view kOperators = "+-*/";
  if (at(sign) == "=") return at(sign + 1) != "=";
  return at(sign).size() == 1 && kOperators.find(at(sign)) != kOperators.npos &&
         at(sign + 1) == "=";
}

}  // namespace

GeometryConstants geometry_constants(std::string_view text) {
  GeometryConstants found;
  const auto tokens = tokens_of(text);
  int depth = 0;  // within DefineConstant: 1 where its names stand
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (depth == 0) {
      if (tokens[i] == "DefineConstant") {
        depth = 1;
        ++i;
      } else if (!tokens[i].empty() && is_word(tokens[i].front()) &&
                 is_assignment(tokens, i + 1)) {
        found.assigned.emplace(tokens[i]);
      }
      continue;
    }
    const bool begins = tokens[i - 1] == "," || opens(tokens[i - 1]);
    if (depth == 1 && begins && !tokens[i].empty() &&
        is_word(tokens[i].front())) {
      found.constants.emplace(tokens[i]);
    }
    if (opens(tokens[i])) ++depth;
    if (closes(tokens[i])) --depth;
  }
  return found;
}

void require_constants(const std::filesystem::path& geometry,
                       const std::vector<part::GeometryParameter>& parameters) {
  if (parameters.empty()) return;
  const GeometryConstants found =
      geometry_constants(geometry_content(geometry));
  const std::string file = geometry.filename().string();
  for (const part::GeometryParameter& parameter : parameters) {
    const std::string& name = parameter.name;
    if (found.assigned.contains(name)) {
      throw Error(
          "S007", parameter.place,
          fmt::format("{} assigns {} itself, whatever is given to it", file,
                      name),
          fmt::format("Write DefineConstant[ {} = ... ]; there instead.",
                      name));
    }
    if (!found.constants.contains(name)) {
      throw Error("S007", parameter.place,
                  fmt::format("{} has no DefineConstant of the name \"{}\"",
                              file, name),
                  scene::suggestion(
                      name, {found.constants.begin(), found.constants.end()}));
    }
  }
}

}  // namespace clevis::app
