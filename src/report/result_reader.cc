#include "report/result_reader.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/errors.h"
#include "report/json_text.h"
#include "report/result_json.h"

namespace clevis::report {
namespace {

using nlohmann::ordered_json;

/// A value of the document that knows its place in the file.
class Node {
 public:
  Node(const ordered_json& value, std::string place)
      : value_(&value), place_(std::move(place)) {}

  bool has(const char* key) const {
    return value_->is_object() && value_->contains(key) &&
           !value_->at(key).is_null();
  }
  Node at(const char* key) const {
    if (!has(key)) refuse(fmt::format("key \"{}\" is missing", key));
    return {value_->at(key), place_ + "/" + key};
  }
  std::vector<Node> elements() const {
    if (!value_->is_array()) refuse("a list is expected here");
    std::vector<Node> nodes;
    for (std::size_t i = 0; i < value_->size(); ++i) {
      nodes.emplace_back((*value_)[i], fmt::format("{}/{}", place_, i));
    }
    return nodes;
  }
  double number() const {
    if (!value_->is_number()) refuse("a number is expected here");
    return value_->get<double>();
  }
  std::string text() const {
    if (!value_->is_string()) refuse("a text is expected here");
    return value_->get<std::string>();
  }
  bool flag() const {
    if (!value_->is_boolean()) refuse("true or false is expected here");
    return value_->get<bool>();
  }
  template <std::size_t n>
  std::array<double, n> numbers() const {
    const std::vector<Node> nodes = elements();
    if (nodes.size() != n) refuse(fmt::format("{} numbers are expected", n));
    std::array<double, n> values{};
    std::ranges::transform(nodes, values.begin(), &Node::number);
    return values;
  }
  std::map<std::string, std::string> texts() const {
    if (!value_->is_object()) refuse("a table is expected here");
    std::map<std::string, std::string> table;
    for (const auto& [key, value] : value_->items()) {
      table[key] = Node(value, place_ + "/" + key).text();
    }
    return table;
  }

 private:
  [[noreturn]] void refuse(const std::string& problem) const {
    throw Error("I003", place_, problem,
                "Run `clevis check` again, or restore the baseline; "
                "docs/result.schema.json tells what the file must hold.");
  }

  const ordered_json* value_;
  std::string place_;
};

Subject mechanism_subject(const Node& mechanism) {
  Subject subject{"mechanism", {}};
  for (const char* key : {"mobility", "redundant_constraints", "instants"}) {
    subject.values[key] = mechanism.at(key).number();
  }
  return subject;
}

Subject joint_subject(const Node& joint) {
  return {"joint " + joint.at("name").text(),
          {{"peak_force", joint.at("peak_force_N").number()},
           {"peak_moment", joint.at("peak_moment_Nm").number()},
           {"peak_instant", joint.at("at_s").number()}}};
}

Subject drive_subject(const Node& drive) {
  Subject subject{"drive " + drive.at("name").text(),
                  {{"peak_instant", drive.at("at_s").number()}}};
  if (drive.has("peak_effort_Nm")) {
    subject.values["peak_torque"] = drive.at("peak_effort_Nm").number();
  } else {
    subject.values["peak_effort"] = drive.at("peak_effort_N").number();
  }
  return subject;
}

Subject part_subject(const Node& part) {
  const Node peak = part.at("peak_von_mises");
  const Node beam = part.at("beam");
  const auto band = peak.at("band_MPa").numbers<2>();
  Subject subject{"part " + part.at("name").text(),
                  {{"verdict", part.at("verdict").text()},
                   {"model", part.at("model").text()},
                   {"mass", part.at("mass_kg").number()},
                   {"peak_verdict", peak.at("verdict").text()},
                   {"peak_von_mises", peak.at("value_MPa").number()},
                   {"band_low", band[0]},
                   {"band_high", band[1]},
                   {"peak_position", peak.at("at_mm").numbers<3>()},
                   {"peak_instant", peak.at("instant_s").number()},
                   {"safety_factor", part.at("safety_factor").number()},
                   {"deflection", part.at("deflection_mm").number()},
                   {"strain_energy", part.at("strain_energy_mJ").number()},
                   {"beam_stress", beam.at("peak_stress_MPa").number()},
                   {"beam_deflection", beam.at("deflection_mm").number()}}};
  if (beam.has("buckling_safety")) {
    subject.values["buckling_safety"] = beam.at("buckling_safety").number();
  }
  return subject;
}

Subject probe_subject(const std::string& part, const Node& probe) {
  Subject subject{fmt::format("probe {}/{} {}", part, probe.at("name").text(),
                              probe.at("quantity").text()),
                  {}};
  if (probe.has("value_mm")) {
    subject.values["probe_displacement"] = probe.at("value_mm").number();
  } else {
    subject.values["probe_stress"] = probe.at("value_MPa").number();
  }
  return subject;
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
  if (schema != kResultSchema) {
    throw Error("R002", file,
                fmt::format("schema {} is not {}, which this clevis writes",
                            schema, kResultSchema),
                "Make result and baseline with the same clevis.");
  }
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
  Subject check{"check", {{"verdict", document.at("verdict").text()}}};
  check.values["complete"] =
      document.at("complete").flag() ? std::string("yes") : std::string("no");
  result.subjects.push_back(check);
  if (document.has("mechanism")) {
    const Node mechanism = document.at("mechanism");
    result.subjects.push_back(mechanism_subject(mechanism));
    for (const Node& joint : mechanism.at("joints").elements()) {
      result.subjects.push_back(joint_subject(joint));
    }
    for (const Node& drive : mechanism.at("drives").elements()) {
      result.subjects.push_back(drive_subject(drive));
    }
  }
  for (const Node& part : document.at("parts").elements()) {
    result.subjects.push_back(part_subject(part));
    for (const Node& probe : part.at("probes").elements()) {
      result.subjects.push_back(probe_subject(part.at("name").text(), probe));
    }
  }
  refuse_duplicates(result);
  return result;
}

}  // namespace clevis::report
