#include "multibody/names.h"

#include <string_view>

#include <fmt/format.h>

namespace clevis::multibody {
namespace {

/// Leaves room for numbers and for suffixes of forces.
constexpr std::size_t kLongest = 44;  // [bytes]

bool is_allowed(char c) {
  constexpr std::string_view kOthers = "._-";
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
         (c >= '0' && c <= '9') || kOthers.find(c) != kOthers.npos;
}

}  // namespace

std::string Names::add(const std::string& name,
                       std::vector<std::string>& told) {
  std::string made;
  for (const char c : name.substr(0, kLongest)) {
    made += is_allowed(c) ? c : '_';
  }
  if (made.empty()) made = kind_;
  if (made[0] == '.' || made[0] == '-') made[0] = '_';
  const std::string first = made;
  for (int number = 2; !taken_.insert(made).second; ++number) {
    made = fmt::format("{}_{}", first, number);
  }
  if (made != name)
    told.push_back(
        fmt::format("{} {}: called {}", kind_, toml_text(name), made));
  return made;
}

std::string one_line(const std::string& text, std::size_t longest) {
  std::string line = text.substr(0, longest);
  const auto continues = [&](std::size_t at) {
    constexpr unsigned char kMask = 0xC0, kContinuation = 0x80;
    return at < text.size() &&
           (static_cast<unsigned char>(text[at]) & kMask) == kContinuation;
  };
  while (!line.empty() && continues(line.size())) line.pop_back();
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7F') c = '?';
  }
  return line;
}

std::string toml_text(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7F') {
      quoted += ' ';
      continue;
    }
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + '"';
}

}  // namespace clevis::multibody
