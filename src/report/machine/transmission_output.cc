#include "report/machine/transmission_output.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "report/text/atomic_file.h"
#include "report/text/csv_field.h"
#include "report/text/json_text.h"
#include "report/text/text_table.h"

namespace clevis::report {
namespace {

using machine::ElementCompliance;
using machine::ModuleError;
using machine::TransmissionResult;
using nlohmann::ordered_json;

constexpr double kArcminute = std::numbers::pi / 180.0 / 60.0;
constexpr double kMicrometre = 1e-6;

const char* compliance_unit(bool angular) {
  return angular ? "rad/(N m)" : "m/N";
}

/// Of an error of the output, in arc minutes or micrometres.
double shown(double error, bool angular) {
  return error / (angular ? kArcminute : kMicrometre);
}

const char* error_unit(bool angular) {
  return angular ? "arcmin" : "um";
}

bool has_ball_screw(const TransmissionResult& result) {
  return result.compliance_other_unit != result.compliance;
}

std::string sums_text(const TransmissionResult& r) {
  const char* unit = compliance_unit(r.angular);
  std::string text = fmt::format(
      "reduced to the output: {:.6g} {}; stiffness {:.6g} {}\n"
      "last stage alone: {:.6g} {}: the whole is {:.4g} times that\n",
      r.compliance, unit, 1.0 / r.compliance, r.angular ? "N m/rad" : "N/m",
      r.last_stage, unit, r.compliance / r.last_stage);
  if (r.last_stage_published != r.last_stage) {
    text += fmt::format(
        "  as printed, teeth not reduced to the output: {:.6g} {}: {:.4g} "
        "times\n",
        r.last_stage_published, unit, r.compliance / r.last_stage_published);
  }
  if (has_ball_screw(r)) {
    text += fmt::format(
        "with the ball screw's formula in {}: {:.6g} {}, {:.4g} times\n",
        r.ball_screw_unit == machine::BallScrewUnit::kCorrected
            ? "mm/N, as printed"
            : "um/N, as its values are",
        r.compliance_other_unit, unit, r.compliance_other_unit / r.compliance);
  }
  return text;
}

std::string two_mass_text(const TransmissionResult& r) {
  if (!r.two_mass) return {};
  const char* unit = r.angular ? "kg m^2" : "kg";
  return fmt::format(
      "two masses on the output: motor {:.6g} {}, load {:.6g} {}; "
      "antiresonance {:.6g} Hz, resonance {:.6g} Hz\n",
      r.two_mass->motor_inertia, unit, r.two_mass->load_inertia, unit,
      r.two_mass->antiresonance, r.two_mass->resonance);
}

std::string frequencies_text(const std::vector<double>& frequencies) {
  std::string text;
  for (const double f : frequencies) {
    text += fmt::format("{}{:.6g}", text.empty() ? "" : ", ", f);
  }
  return text;
}

std::string chain_text(const TransmissionResult& r) {
  if (!r.chain) return {};
  return fmt::format(
      "with the stages' inertia: antiresonances {} Hz, resonances {} Hz\n",
      frequencies_text(r.chain->antiresonances),
      frequencies_text(r.chain->resonances));
}

std::string error_text(const TransmissionResult& r) {
  if (!r.error) return {};
  const ModuleError& e = *r.error;
  const auto in_unit = [&r](double value) {
    return shown(value, r.angular);
  };
  std::string text = fmt::format(
      "error of the output, {}: control {:.6g}, kinematic {:.6g}, backlash "
      "{:.6g}, compliance {:.6g}; worst case {:.6g}, root of squares {:.6g}\n"
      "reversal, backlash + 2 friction x compliance: {:.6g}",
      error_unit(r.angular), in_unit(e.shares.control),
      in_unit(e.shares.kinematic), in_unit(e.shares.backlash),
      in_unit(e.compliance), in_unit(e.worst), in_unit(e.rss),
      in_unit(e.reversal));
  if (e.reversal_run) {
    text += fmt::format("; by a run of both masses: {:.6g} ({:.1e} off)",
                        in_unit(*e.reversal_run),
                        std::abs(*e.reversal_run / e.reversal - 1.0));
  }
  return text + "\n";
}

std::string one_text(const TransmissionResult& r, Colour colour) {
  TextTable table({{"stage"},
                   {"element"},
                   {"type"},
                   {"formula"},
                   {"own", Align::kRight},
                   {"unit"},
                   {"u", Align::kRight},
                   {"on the output", Align::kRight},
                   {"%", Align::kRight}});
  constexpr double kPercent = 100.0;
  for (const ElementCompliance& e : r.elements) {
    table.add_row(
        {{e.stage},
         {e.name},
         {e.type},
         {e.formula},
         {fmt::format("{:.4e}", e.own)},
         {compliance_unit(e.angular)},
         {fmt::format("{:.6g}", e.ratio)},
         {fmt::format("{:.4e}", e.reduced)},
         {fmt::format("{:.2f}", kPercent * e.reduced / r.compliance)}});
  }
  std::string text = printable(r.name);
  text += '\n';
  text += table.text(colour);
  return text + sums_text(r) + two_mass_text(r) + chain_text(r) + error_text(r);
}

ordered_json elements_json(const TransmissionResult& r) {
  const char* reduced =
      r.angular ? "on_output_rad_per_N_m" : "on_output_m_per_N";
  ordered_json list = ordered_json::array();
  for (const ElementCompliance& e : r.elements) {
    list.push_back({{"stage", e.stage},
                    {"name", e.name},
                    {"type", e.type},
                    {"formula", e.formula},
                    {e.angular ? "own_rad_per_N_m" : "own_m_per_N", e.own},
                    {"ratio", e.ratio},
                    {reduced, e.reduced}});
  }
  return list;
}

ordered_json error_json(const TransmissionResult& r) {
  const ModuleError& e = *r.error;
  const std::string unit = r.angular ? "_rad" : "_m";
  ordered_json json = {{"control" + unit, e.shares.control},
                       {"kinematic" + unit, e.shares.kinematic},
                       {"backlash" + unit, e.shares.backlash},
                       {"compliance" + unit, e.compliance},
                       {"worst_case" + unit, e.worst},
                       {"root_of_squares" + unit, e.rss},
                       {"reversal" + unit, e.reversal}};
  json["reversal_run" + unit] =
      e.reversal_run ? ordered_json(*e.reversal_run) : ordered_json();
  return json;
}

ordered_json one_json(const TransmissionResult& r) {
  const std::string unit = r.angular ? "_rad_per_N_m" : "_m_per_N";
  ordered_json json = {{"name", r.name}, {"ratio", r.ratio}};
  json["compliance" + unit] = r.compliance;
  json["compliance_other_ball_screw_unit" + unit] = r.compliance_other_unit;
  json["last_stage" + unit] = r.last_stage;
  json["last_stage_published" + unit] = r.last_stage_published;
  json["elements"] = elements_json(r);
  if (r.two_mass) {
    const std::string mass = r.angular ? "_inertia_kg_m2" : "_mass_kg";
    json["two_mass"] = {{"motor" + mass, r.two_mass->motor_inertia},
                        {"load" + mass, r.two_mass->load_inertia},
                        {"antiresonance_Hz", r.two_mass->antiresonance},
                        {"resonance_Hz", r.two_mass->resonance}};
  }
  if (r.chain) {
    json["chain"] = {{"antiresonances_Hz", r.chain->antiresonances},
                     {"resonances_Hz", r.chain->resonances}};
  }
  if (r.error) json["error"] = error_json(r);
  return json;
}

}  // namespace

std::string transmission_text(const TransmissionReport& report, Colour colour) {
  std::string text = printable(report.scene);
  text += '\n';
  for (const TransmissionResult& result : report.transmissions) {
    text += '\n';
    text += one_text(result, colour);
  }
  return text;
}

std::string transmission_json(const TransmissionReport& report) {
  ordered_json list = ordered_json::array();
  for (const TransmissionResult& result : report.transmissions) {
    list.push_back(one_json(result));
  }
  const ordered_json json = {{"schema", kSchema},
                             {"version", report.version},
                             {"scene", report.scene},
                             {"transmissions", list}};
  refuse_non_finite(json, "transmission");
  return json_text(json);
}

std::string transmission_csv(const TransmissionReport& report) {
  std::string text =
      "transmission,stage,element,type,formula,own,own_unit,ratio,"
      "on_output,on_output_unit\n";
  for (const TransmissionResult& r : report.transmissions) {
    for (const ElementCompliance& e : r.elements) {
      text += fmt::format("{},{},{},{},{},{:.12g},{},{:.12g},{:.12g},{}\n",
                          csv_field(r.name), csv_field(e.stage),
                          csv_field(e.name), e.type, csv_field(e.formula),
                          e.own, compliance_unit(e.angular), e.ratio, e.reduced,
                          compliance_unit(r.angular));
    }
  }
  return text;
}

void write_transmission_files(const TransmissionReport& report,
                              const std::filesystem::path& folder) {
  const std::string json = transmission_json(report);  // refuses first
  write_file(folder / "transmission.csv", transmission_csv(report));
  write_file(folder / "transmission.json", json);
}

}  // namespace clevis::report
