#include "report/text/json_text.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/messages/errors.h"

namespace clevis::report {

using nlohmann::ordered_json;

namespace {

constexpr const char* kRestore =
    "Run `clevis check` again, or restore the baseline.";

/// The first number that is not finite, and the way to it.
struct NonFinite {
  double value{};
  std::string way = {};  ///< "/parts/0/mass"
};
std::optional<NonFinite> find_non_finite(const ordered_json& json) {
  if (json.is_number_float()) {
    const auto value = json.get<double>();
    if (!std::isfinite(value)) return NonFinite{value};
  }
  std::optional<NonFinite> found;
  if (json.is_array()) {
    for (std::size_t i = 0; i < json.size() && !found; ++i) {
      found = find_non_finite(json[i]);
      if (found) found->way = fmt::format("/{}{}", i, found->way);
    }
  } else if (json.is_object()) {
    for (auto item = json.begin(); item != json.end() && !found; ++item) {
      found = find_non_finite(*item);
      if (found) found->way = fmt::format("/{}{}", item.key(), found->way);
    }
  }
  return found;
}

}  // namespace

void refuse_non_finite(const ordered_json& document, const std::string& place) {
  const auto found = find_non_finite(document);
  if (!found) return;
  throw Error("F003", place,
              fmt::format("{} is {}, not a finite number",
                          found->way.empty() ? "it" : found->way.substr(1),
                          found->value),
              "Please report the scene: a result must be finite.");
}

std::string json_text(const ordered_json& document) {
  return document.dump(2, ' ', false, ordered_json::error_handler_t::replace) +
         "\n";
}

std::string valid_utf8(const std::string& text) {
  const auto replace = ordered_json::error_handler_t::replace;
  return ordered_json::parse(ordered_json(text).dump(-1, ' ', false, replace))
      .get<std::string>();
}

ordered_json read_json(const std::filesystem::path& file) {
  std::error_code failure;
  const auto status = std::filesystem::status(file, failure);
  if (std::filesystem::exists(status) &&
      !std::filesystem::is_regular_file(status) &&
      !std::filesystem::is_directory(status)) {
    throw Error("I001", file.string(), "is not a regular file",
                "Give a result.json or the folder that holds it.");
  }
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream content;
  // A folder opens as a stream but cannot be read; an empty file sets
  // failbit on `content` only.
  if (stream) content << stream.rdbuf();
  if (!stream || std::filesystem::is_directory(file)) {
    throw Error("I001", file.string(),
                std::string("cannot read file: ") + std::strerror(errno),
                "Give a result.json or the folder that holds it.");
  }
  const std::string text = content.str();
  try {
    return ordered_json::parse(text);
  } catch (const ordered_json::parse_error& error) {
    const std::size_t end =
        std::min(error.byte > 0 ? error.byte - 1 : 0, text.size());
    const std::string before = text.substr(0, end);
    const auto line = 1 + std::ranges::count(before, '\n');
    const std::size_t start = before.rfind('\n') + 1;  // npos + 1 = 0
    throw Error(
        "I003",
        fmt::format("{}:{}:{}", file.string(), line, before.size() - start + 1),
        text.empty() ? "the file is empty" : "the text is not JSON", kRestore);
  } catch (const ordered_json::out_of_range&) {
    throw Error("I003", file.string(), "a number is too large", kRestore);
  }
}

}  // namespace clevis::report
