#include "report/compare/result_reader.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/messages/errors.h"
#include "report/check/check_quantities.h"
#include "report/check/result_json.h"
#include "report/compare/quantity_reader.h"
#include "report/compare/transmission_reader.h"
#include "report/machine/bearing_quantities.h"
#include "report/parts/impact_quantities.h"
#include "report/parts/limit_quantities.h"
#include "report/parts/part_quantities.h"
#include "report/parts/probe_quantities.h"
#include "report/summary/mechanism_quantities.h"
#include "report/text/json_node.h"
#include "report/text/json_text.h"

namespace clevis::report {
namespace {

using nlohmann::ordered_json;
using Node = JsonNode;

/// "joint D".
std::string name_of(const char* kind, const Node& node) {
  return fmt::format("{} {}", kind, node.at("name").text());
}

void add_mechanism(const Node& mechanism, std::vector<Subject>& subjects) {
  subjects.push_back(
      stored_subject("mechanism", mechanism_quantities(), mechanism));
  for (const Node& joint : mechanism.at("joints").elements()) {
    subjects.push_back(
        stored_subject(name_of("joint", joint), joint_quantities(), joint));
  }
  for (const Node& drive : mechanism.at("drives").elements()) {
    subjects.push_back(
        stored_subject(name_of("drive", drive), drive_quantities(), drive));
  }
}

/// A blow and its models, which are told apart by their order: degrees and
/// shapes may change their names.
void add_blow(const std::string& part, const Node& blow,
              std::vector<Subject>& subjects) {
  const std::string name =
      fmt::format("impact {}/{}", part, blow.at("name").text());
  subjects.push_back(stored_subject(name, blow_quantities(), blow));
  int number = 0;
  for (const Node& row : blow.at("models").elements()) {
    subjects.push_back(
        stored_subject(fmt::format("{}, model {}", name, ++number),
                       blow_model_quantities(), row));
  }
}

Subject vibration_subject(const std::string& name, const Node& vibration) {
  if (vibration.has("failure"))
    return {name, {{"complete", std::string("no")}}};
  return stored_subject(name, vibration_quantities(), vibration);
}

void add_part(const Node& part, std::vector<Subject>& subjects) {
  const std::string name = part.at("name").text();
  subjects.push_back(stored_subject("part " + name, part_quantities(), part));
  subjects.push_back(stored_subject("limits of " + name, limit_quantities(),
                                    part.at("limits")));
  if (part.has("impacts")) {
    for (const Node& blow : part.at("impacts").elements()) {
      add_blow(name, blow, subjects);
    }
  }
  if (part.has("vibration")) {
    subjects.push_back(
        vibration_subject("vibration " + name, part.at("vibration")));
  }
  for (const Node& probe : part.at("probes").elements()) {
    subjects.push_back(stored_subject(
        fmt::format("probe {}/{} {}", name, probe.at("name").text(),
                    probe.at("quantity").text()),
        probe_quantities(), probe));
  }
}

void refuse_duplicates(const StoredResult& result) {
  std::map<std::string, int> count;
  for (const Subject& subject : result.subjects) {
    if (++count[subject.name] == 2) {
      throw Error("I003", result.file.string(),
                  subject.name + " stands there twice",
                  "Run `clevis check` again, or restore the baseline.");
    }
  }
}

void check_schema(const Node& document, const std::string& file) {
  const double schema = document.at("schema").number();
  if (schema != kSchema) {
    throw Error("R002", file,
                fmt::format("schema {} is not {}, which this clevis writes",
                            schema, kSchema),
                "Make result and baseline with the same clevis.");
  }
}

/// Of a result.json.
std::vector<Subject> check_subjects(const Node& document) {
  std::vector<Subject> subjects;
  subjects.push_back(stored_subject("check", check_quantities(), document));
  if (document.has("mechanism")) {
    add_mechanism(document.at("mechanism"), subjects);
  }
  for (const Node& part : document.at("parts").elements()) {
    add_part(part, subjects);
  }
  if (document.has("bearings")) {
    for (const Node& bearing : document.at("bearings").elements()) {
      subjects.push_back(stored_subject(name_of("bearing", bearing),
                                        bearing_quantities(), bearing));
    }
  }
  return subjects;
}

}  // namespace

StoredResult read_result(const std::filesystem::path& file_or_folder) {
  StoredResult result;
  result.file = std::filesystem::is_directory(file_or_folder)
                    ? file_or_folder / "result.json"
                    : file_or_folder;
  const ordered_json json = read_json(result.file);
  const Node document(json, result.file.string() + ":");
  check_schema(document, result.file.string());
  result.scene = document.at("scene").text();
  result.version = document.at("version").text();
  if (document.has("tolerances")) {
    result.tolerances = document.at("tolerances").texts();
  }
  result.subjects = document.has("transmissions")
                        ? transmission_subjects(document)
                        : check_subjects(document);
  refuse_duplicates(result);
  return result;
}

}  // namespace clevis::report
