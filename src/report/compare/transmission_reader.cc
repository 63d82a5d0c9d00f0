#include "report/compare/transmission_reader.h"

#include <initializer_list>
#include <string>
#include <utility>

namespace clevis::report {
namespace {

using Keys = std::initializer_list<std::pair<const char*, const char*>>;

/// Numbers of a table whose keys end in the unit of the output, where there.
void add_numbers(const JsonNode& table, const std::string& unit, Keys keys,
                 Subject& subject) {
  for (const auto& [key, quantity] : keys) {
    const std::string name = key + unit;
    if (!table.has(name.c_str())) continue;
    subject.values[quantity] = table.at(name.c_str()).number();
  }
}

void add_list(const JsonNode& list, const std::string& quantity,
              const std::string& name, std::vector<Subject>& subjects) {
  std::size_t count = 0;
  for (const JsonNode& value : list.elements()) {
    subjects.push_back(
        {fmt::format("{} of {}, no. {}", quantity, name, ++count),
         {{"frequency", value.number()}}});
  }
}

void add_elements(const JsonNode& transmission, const std::string& name,
                  std::vector<Subject>& subjects) {
  for (const JsonNode& element : transmission.at("elements").elements()) {
    const bool turns = element.has("own_rad_per_N_m");
    subjects.push_back(
        {fmt::format("element {}/{}/{}", name, element.at("stage").text(),
                     element.at("name").text()),
         {{"compliance",
           element.at(turns ? "own_rad_per_N_m" : "own_m_per_N").number()},
          {"ratio", element.at("ratio").number()}}});
  }
}

void add_transmission(const JsonNode& transmission,
                      std::vector<Subject>& subjects) {
  const std::string name = transmission.at("name").text();
  const bool turns = transmission.has("compliance_rad_per_N_m");
  Subject subject{"transmission " + name,
                  {{"ratio", transmission.at("ratio").number()}}};
  add_numbers(transmission, turns ? "_rad_per_N_m" : "_m_per_N",
              {{"compliance", "compliance"}, {"last_stage", "last_stage"}},
              subject);
  if (transmission.has("error")) {
    add_numbers(transmission.at("error"), turns ? "_rad" : "_m",
                {{"worst_case", "worst_case"},
                 {"root_of_squares", "root_of_squares"},
                 {"reversal", "reversal"},
                 {"reversal_run", "reversal_run"}},
                subject);
  }
  subjects.push_back(std::move(subject));
  if (transmission.has("two_mass")) {
    const JsonNode model = transmission.at("two_mass");
    subjects.push_back(
        {"antiresonance of " + name,
         {{"frequency", model.at("antiresonance_Hz").number()}}});
    subjects.push_back({"resonance of " + name,
                        {{"frequency", model.at("resonance_Hz").number()}}});
  }
  if (transmission.has("chain")) {
    const JsonNode chain = transmission.at("chain");
    add_list(chain.at("antiresonances_Hz"), "chain's antiresonance", name,
             subjects);
    add_list(chain.at("resonances_Hz"), "chain's resonance", name, subjects);
  }
  add_elements(transmission, name, subjects);
}

}  // namespace

std::vector<Subject> transmission_subjects(const JsonNode& document) {
  std::vector<Subject> subjects;
  for (const JsonNode& each : document.at("transmissions").elements()) {
    add_transmission(each, subjects);
  }
  return subjects;
}

}  // namespace clevis::report
