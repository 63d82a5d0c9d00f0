#include "report/page/result_folder.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/messages/errors.h"
#include "report/check/result_json.h"
#include "report/compare/result_reader.h"
#include "report/text/json_node.h"
#include "report/text/json_text.h"
#include "report/view/input_file.h"
#include "report/view/view_files.h"

namespace clevis::report {
namespace {

namespace fs = std::filesystem;

constexpr const char* kAgain =
    "Run `clevis check` or `clevis simulate --out` of this version again.";

[[noreturn]] void refuse(const fs::path& place, const std::string& problem) {
  throw Error("I008", place.string(), problem, kAgain);
}

/// A JSON file of clevis: its text, once it is known to be one.
struct StoredFile {
  std::string text;
  nlohmann::ordered_json json;
};

StoredFile read_stored(const fs::path& file, const char* kind,
                       int schema = kSchema) {
  if (!fs::is_regular_file(file)) {
    refuse(file, fmt::format("the result has no {}", kind));
  }
  StoredFile stored{file_text(file), read_json(file)};
  const auto& json = stored.json;
  if (!json.is_object() || !json.contains("schema") ||
      json["schema"] != schema) {
    refuse(file, "it is none of clevis, or of another version");
  }
  return stored;
}

/// Takes out what differs from run to run of one input: times that it took.
void remove_seconds(nlohmann::ordered_json& json) {
  if (json.is_object()) json.erase("seconds");
  for (auto& value : json) {
    if (value.is_structured()) remove_seconds(value);
  }
}

fs::path result_file(const fs::path& folder, ResultKind kind) {
  return folder /
         (kind == ResultKind::kCheck ? "result.json" : "simulate.json");
}

std::string title_of(const JsonNode& result) {
  const std::string scene = result.at("scene").text();
  return result.has("verdict")
             ? fmt::format("{}: {}", scene, result.at("verdict").text())
             : scene;
}

}  // namespace

ResultKind result_kind(const fs::path& folder) {
  if (!fs::is_directory(folder)) {
    throw Error("I001", folder.string(), "there is no such folder",
                "Give the folder that `clevis check` wrote.");
  }
  for (const ResultKind kind : {ResultKind::kCheck, ResultKind::kSimulation}) {
    if (fs::exists(result_file(folder, kind))) return kind;
  }
  refuse(folder, "the folder holds neither a result.json nor a simulate.json");
}

StoredPage read_result_folder(const fs::path& folder, ResultKind kind) {
  const fs::path file = result_file(folder, kind);
  StoredFile result = read_stored(file, "result");
  if (kind == ResultKind::kCheck) read_result(file);  // refuses damaged values
  remove_seconds(result.json);
  const JsonNode document(result.json, file.string() + ":");
  const StoredFile motion =
      read_stored(motion_view_file(folder, kind), "view of its mechanism");
  const std::string scene = document.at("scene").text();
  if (JsonNode(motion.json, "").at("scene").text() != scene) {
    refuse(motion_view_file(folder, kind),
           "it is of another scene than the result");
  }
  StoredPage page{title_of(document), json_text(result.json), motion.text, {}};
  if (kind == ResultKind::kSimulation) return page;
  for (const JsonNode& part : document.at("parts").elements()) {
    const std::string name = part.at("name").text();
    page.parts.push_back(read_stored(part_view_file(folder, name),
                                     "view of the part", kPartViewSchema)
                             .text);
  }
  for (const JsonNode& failure : document.at("failures").elements()) {
    const fs::path shape = part_view_file(folder, failure.at("part").text());
    if (!fs::is_regular_file(shape)) continue;
    page.shapes.push_back(
        read_stored(shape, "view of the part", kPartViewSchema).text);
  }
  return page;
}

}  // namespace clevis::report
