#include "report/compare/part_impact_reader.h"

#include <array>
#include <string>

#include <fmt/format.h>

namespace clevis::report {
namespace {

using Node = JsonNode;

/// Key in the file, quantity; what is null there is not compared.
using Numbers = std::initializer_list<std::array<const char*, 2>>;

void add_numbers(const Node& node, const Numbers& numbers, Subject& subject) {
  for (const auto& [key, quantity] : numbers) {
    if (node.has(key)) subject.values[quantity] = node.at(key).number();
  }
}

void add_band(const Node& band, const char* low, const char* high,
              Subject& subject) {
  const auto ends = band.numbers<2>();
  subject.values[low] = ends[0];
  subject.values[high] = ends[1];
}

Subject blow_subject(const std::string& name, const Node& blow) {
  Subject subject{name, {}};
  add_numbers(blow,
              {{"mass_kg", "striker_mass"},
               {"speed_m_per_s", "striker_speed"},
               {"pushing_N", "striker_force"},
               {"first_period_s", "first_period"},
               {"load_duration_s", "contact_duration"},
               {"rise_time_s", "contact_rise"},
               {"peak_force_N", "contact_force"},
               {"dynamic_factor", "dynamic_factor"},
               {"stress_MPa", "peak_von_mises"},
               {"deflection_mm", "deflection"},
               {"later_stress_ratio", "later_stress"},
               {"later_deflection_ratio", "later_deflection"},
               {"free_swing_stress_ratio", "free_swing_stress"},
               {"free_swing_deflection_ratio", "free_swing_deflection"},
               {"safety_factor", "safety_factor"}},
              subject);
  add_band(blow.at("band_MPa"), "band_low", "band_high", subject);
  if (blow.has("deflection_band_mm")) {
    add_band(blow.at("deflection_band_mm"), "deflection_low", "deflection_high",
             subject);
  }
  add_held_section(blow, subject);
  const bool settles = !blow.has("refinement") ||
                       blow.at("refinement").at("stress_settles").flag();
  subject.values["settles"] = std::string(settles ? "yes" : "no");
  return subject;
}

/// Degrees and shapes may change, so a model's name is noted only.
Subject model_subject(const std::string& name, const Node& row) {
  Subject subject{name, {{"model", row.at("model").text()}}};
  add_numbers(row,
              {{"stress_MPa", "peak_von_mises"},
               {"root_stress_MPa", "section_stress"},
               {"face_deflection_mm", "face_deflection"},
               {"deflection_mm", "deflection"}},
              subject);
  return subject;
}

Subject vibration_subject(const std::string& part, const Node& vibration) {
  Subject subject{"vibration " + part, {}};
  if (vibration.has("failure")) {
    subject.values["complete"] = std::string("no");
    return subject;
  }
  add_numbers(vibration,
              {{"ratio", "vibration_ratio"},
               {"peak_MPa", "peak_von_mises"},
               {"instant_s", "peak_instant"}},
              subject);
  add_band(vibration.at("band_MPa"), "band_low", "band_high", subject);
  subject.values["model"] = vibration.at("model").text();
  return subject;
}

}  // namespace

void add_held_section(const Node& holder, Subject& subject) {
  if (!holder.has("held_section")) return;
  const Node section = holder.at("held_section");
  subject.values["section_stress"] = section.at("nominal_stress_MPa").number();
  add_band(section.at("band_MPa"), "section_low", "section_high", subject);
}

std::vector<Subject> impact_subjects(const Node& part) {
  std::vector<Subject> subjects;
  const std::string name = part.at("name").text();
  if (part.has("impacts")) {
    for (const Node& blow : part.at("impacts").elements()) {
      const std::string of =
          fmt::format("impact {}/{}", name, blow.at("name").text());
      subjects.push_back(blow_subject(of, blow));
      int number = 0;
      for (const Node& row : blow.at("models").elements()) {
        subjects.push_back(
            model_subject(fmt::format("{}, model {}", of, ++number), row));
      }
    }
  }
  if (part.has("vibration")) {
    subjects.push_back(vibration_subject(name, part.at("vibration")));
  }
  return subjects;
}

}  // namespace clevis::report
