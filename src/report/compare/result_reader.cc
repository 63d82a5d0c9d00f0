#include "report/compare/result_reader.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/errors.h"
#include "report/check/result_json.h"
#include "report/compare/part_impact_reader.h"
#include "report/compare/transmission_reader.h"
#include "report/text/json_node.h"
#include "report/text/json_text.h"

namespace clevis::report {
namespace {

using nlohmann::ordered_json;
using Node = JsonNode;

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
  if (part.has("buckling") && part.at("buckling").has("factor")) {
    subject.values["buckling_factor"] =
        part.at("buckling").at("factor").number();
  }
  add_held_section(part, subject);
  return subject;
}

Subject bearing_subject(const Node& bearing) {
  Subject subject{"bearing " + bearing.at("name").text(),
                  {{"verdict", bearing.at("verdict").text()},
                   {"bearing_load", bearing.at("mean_load_N").number()},
                   {"static_load", bearing.at("static_load_N").number()}}};
  // null without load or turning
  if (bearing.has("static_safety")) {
    subject.values["static_safety"] = bearing.at("static_safety").number();
  }
  if (bearing.has("life_h")) {
    subject.values["bearing_life"] = bearing.at("life_h").number();
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

/// Of a result.json.
std::vector<Subject> check_subjects(const Node& document) {
  std::vector<Subject> subjects;
  Subject check{"check", {{"verdict", document.at("verdict").text()}}};
  check.values["complete"] =
      document.at("complete").flag() ? std::string("yes") : std::string("no");
  subjects.push_back(check);
  if (document.has("mechanism")) {
    const Node mechanism = document.at("mechanism");
    subjects.push_back(mechanism_subject(mechanism));
    for (const Node& joint : mechanism.at("joints").elements()) {
      subjects.push_back(joint_subject(joint));
    }
    for (const Node& drive : mechanism.at("drives").elements()) {
      subjects.push_back(drive_subject(drive));
    }
  }
  for (const Node& part : document.at("parts").elements()) {
    subjects.push_back(part_subject(part));
    for (Subject& subject : impact_subjects(part)) {
      subjects.push_back(std::move(subject));
    }
    for (const Node& probe : part.at("probes").elements()) {
      subjects.push_back(probe_subject(part.at("name").text(), probe));
    }
  }
  if (document.has("bearings")) {
    for (const Node& bearing : document.at("bearings").elements()) {
      subjects.push_back(bearing_subject(bearing));
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
