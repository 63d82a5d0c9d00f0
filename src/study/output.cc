#include "study/output.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "report/text/json_text.h"

namespace clevis::study {
namespace {

using nlohmann::ordered_json;

constexpr double kMegapascal = 1e6, kMillijoule = 1e-3, kMegabyte = 1e6;
constexpr double kMillimetre = 1e-3;

double probe_unit(bool is_stress) {
  return is_stress ? kMegapascal : kMillimetre;
}

const char* probe_unit_name(bool is_stress) {
  return is_stress ? "MPa" : "mm";
}

/// A text as a CSV cell: always quoted, quotes doubled.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"') result += '"';
    result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return result + "\"";
}

std::string csv_row(const PartStudy& part, const Run& run) {
  if (!run.left_out.empty()) {
    return fmt::format("{},{},{}\n", quoted(run.series), quoted(run.setting),
                       quoted("left out: " + run.left_out));
  }
  const auto& s = run.seconds;
  std::string row = fmt::format(
      "{},{},,{},{:.4g},{:.4g},{:.4g},{:.4g},{:.4g},{:.4g},{:.4g},{:.1f},"
      "{:.8g},{:.3g},{:.10g},{:.3g}",
      quoted(run.series), quoted(run.setting), run.dofs, s.total,
      run.cpu_seconds, s.mesh, s.assemble, s.factor, s.solve, s.recover,
      run.memory / kMegabyte, run.peak / kMegapascal,
      100.0 * relative_error(run.peak, part.peak), run.energy / kMillijoule,
      100.0 * relative_error(run.energy, part.energy));
  row += run.checked ? fmt::format(",{:.8g},{:.8g}",
                                   run.checked->band_low / kMegapascal,
                                   run.checked->band_high / kMegapascal)
                     : ",,";
  row += run.displacement_difference
             ? fmt::format(",{:.3g}", 100.0 * *run.displacement_difference)
             : ",";
  for (std::size_t p = 0; p < part.probes.size(); ++p) {
    row +=
        p < run.probes.size()
            ? fmt::format(",{:.8g},{:.3g}",
                          run.probes[p] / probe_unit(part.is_stress[p]),
                          100.0 * relative_error(run.probes[p], part.probes[p]))
            : ",,";
  }
  return row + "\n";
}

ordered_json json_of(const Reference& reference, double unit,
                     const std::string& suffix) {
  return {{"value_" + suffix, reference.value / unit},
          {"uncertainty_" + suffix, reference.uncertainty / unit}};
}

ordered_json json_of(const PartStudy& part, const Run& run) {
  ordered_json json{{"series", run.series}, {"setting", run.setting}};
  if (!run.left_out.empty()) {
    json["left_out"] = run.left_out;
    return json;
  }
  const auto& s = run.seconds;
  json["dofs"] = run.dofs;
  json["seconds"] = {{"total", s.total},    {"cpu", run.cpu_seconds},
                     {"mesh", s.mesh},      {"assemble", s.assemble},
                     {"factor", s.factor},  {"solve", s.solve},
                     {"recover", s.recover}};
  json["memory_MB"] = run.memory / kMegabyte;
  json["peak_MPa"] = run.peak / kMegapascal;
  json["peak_error"] = relative_error(run.peak, part.peak);
  json["energy_mJ"] = run.energy / kMillijoule;
  json["energy_error"] = relative_error(run.energy, part.energy);
  if (run.checked) {
    json["band_MPa"] = {run.checked->band_low / kMegapascal,
                        run.checked->band_high / kMegapascal};
  }
  if (run.displacement_difference) {
    json["displacement_difference"] = *run.displacement_difference;
  }
  if (run.probes.empty()) return json;
  for (std::size_t p = 0; p < part.probes.size(); ++p) {
    json["probes"].push_back(
        {{"name", part.probe_names[p]},
         {fmt::format("value_{}", probe_unit_name(part.is_stress[p])),
          run.probes.at(p) / probe_unit(part.is_stress[p])},
         {"error", relative_error(run.probes.at(p), part.probes[p])}});
  }
  return json;
}

}  // namespace

std::string study_csv(const PartStudy& part) {
  std::string text =
      "series,setting,note,dofs,seconds,cpu_seconds,mesh_s,assemble_s,"
      "factor_s,solve_s,recover_s,memory_MB,peak_MPa,peak_error_percent,"
      "energy_mJ,energy_error_percent,band_low_MPa,band_high_MPa,"
      "displacement_difference_percent";
  for (std::size_t p = 0; p < part.probes.size(); ++p) {
    text += fmt::format(",{},{}",
                        quoted(fmt::format("{} {}", part.probe_names[p],
                                           probe_unit_name(part.is_stress[p]))),
                        quoted(part.probe_names[p] + " error percent"));
  }
  text += "\n";
  for (const Run& run : part.runs) text += csv_row(part, run);
  return text;
}

ordered_json study_json(const Study& study) {
  ordered_json json{
      {"schema", report::kSchema},  {"version", study.version},
      {"scene", study.scene},       {"complete", study.complete},
      {"calculix", study.calculix}, {"parts", ordered_json::array()}};
  for (const PartStudy& part : study.parts) {
    ordered_json entry{{"name", part.name},
                       {"load", part.load},
                       {"instants", part.instants},
                       {"reference", {{"run", part.reference_run}}},
                       {"runs", ordered_json::array()}};
    ordered_json& reference = entry["reference"];
    reference["peak"] = json_of(part.peak, kMegapascal, "MPa");
    reference["energy"] = json_of(part.energy, kMillijoule, "mJ");
    for (std::size_t p = 0; p < part.probes.size(); ++p) {
      ordered_json probe{{"name", part.probe_names[p]}};
      probe.update(json_of(part.probes[p], probe_unit(part.is_stress[p]),
                           probe_unit_name(part.is_stress[p])));
      reference["probes"].push_back(probe);
    }
    for (const Run& run : part.runs)
      entry["runs"].push_back(json_of(part, run));
    json["parts"].push_back(entry);
  }
  return json;
}

std::string encode(const Run& run) {
  const auto& s = run.seconds;
  nlohmann::json json{
      {"series", run.series},
      {"setting", run.setting},
      {"dofs", run.dofs},
      {"peak", run.peak},
      {"energy", run.energy},
      {"probes", run.probes},
      {"seconds", {s.mesh, s.assemble, s.factor, s.solve, s.recover, s.total}},
      {"cpu", run.cpu_seconds},
      {"memory", run.memory},
      {"left_out", run.left_out}};
  if (run.checked) {
    json["band"] = {run.checked->band_low, run.checked->band_high};
  }
  if (run.displacement_difference) {
    json["difference"] = *run.displacement_difference;
  }
  return json.dump();
}

Run decode_run(const std::string& text) {
  const auto json = nlohmann::json::parse(text);
  Run run;
  run.series = json.at("series");
  run.setting = json.at("setting");
  run.dofs = json.at("dofs");
  run.peak = json.at("peak");
  run.energy = json.at("energy");
  run.probes = json.at("probes").get<std::vector<double>>();
  auto& s = run.seconds;
  const auto& seconds = json.at("seconds");
  s.mesh = seconds.at(0);
  s.assemble = seconds.at(1);
  s.factor = seconds.at(2);
  s.solve = seconds.at(3);
  s.recover = seconds.at(4);
  s.total = seconds.at(5);
  run.cpu_seconds = json.at("cpu");
  run.memory = json.at("memory");
  run.left_out = json.at("left_out");
  if (json.contains("band")) {
    run.checked.emplace();
    run.checked->band_low = json["band"].at(0);
    run.checked->band_high = json["band"].at(1);
  }
  if (json.contains("difference")) {
    run.displacement_difference = json["difference"];
  }
  return run;
}

}  // namespace clevis::study
