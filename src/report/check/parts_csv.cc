#include "report/check/parts_csv.h"

#include <vector>

#include <fmt/format.h>

#include "report/parts/buckling_output.h"
#include "report/text/csv_field.h"
#include "report/text/units.h"

namespace clevis::report {
namespace {

/// One column: its title with the unit, and its text for a part.
struct Field {
  std::string title, text;
};

std::string number(double value) {
  return fmt::format("{}", value);
}

std::vector<Field> fields(const assessment::PartResult& part) {
  const assessment::PeakStress& peak = part.peak;
  const Eigen::Vector3d at = millimetres(peak.at);
  std::vector<Field> all = {
      {"part", part.name},
      {"verdict", std::string(text(part.verdict))},
      {"why", part.why},
      {"model", part.model},
      {"stopped_because", part.stopped_because},
      {"dofs", std::to_string(part.dofs)},
      {"cells", std::to_string(part.cells)},
      {"mass[kg]", number(part.mass)},
      {"peak_von_mises[MPa]", number(megapascals(peak.value))},
      {"band_low[MPa]", number(megapascals(peak.band_low))},
      {"band_high[MPa]", number(megapascals(peak.band_high))},
      {"discretization_error[MPa]",
       number(megapascals(peak.discretization_error))},
      {"model_error[MPa]", number(megapascals(peak.model_error))},
      {"mesh_error[MPa]", number(megapascals(peak.shares.mesh))},
      {"time_error[MPa]", number(megapascals(peak.shares.time))},
      {"sharing_error[MPa]", number(megapascals(peak.shares.sharing))},
      {"peak_verdict", std::string(text(peak.verdict))},
      {"peak_group", peak.group},
      {"peak_x[mm]", number(at.x())},
      {"peak_y[mm]", number(at.y())},
      {"peak_z[mm]", number(at.z())},
      {"peak_instant[s]", number(peak.instant)},
      {"peak_case", peak.label},
      {"safety_factor[1]", number(part.safety_factor)},
      {"deflection[mm]", number(millimetres(part.deflection))},
      {"deflection_low[mm]", number(millimetres(part.deflection_low))},
      {"deflection_high[mm]", number(millimetres(part.deflection_high))},
      {"strain_energy[mJ]", number(millijoules(part.strain_energy))},
      {"beam_stress[MPa]", number(megapascals(part.beam.peak_stress))},
      {"beam_governing", part.beam.governing},
      {"beam_deflection[mm]", number(millimetres(part.beam.deflection))},
      {"ratio_fe_to_beam[1]", number(part.beam.ratio_fe_to_beam)},
      {"ratio_reason", part.beam.reason},
  };
  for (const auto& [title, text] : buckling_columns(part)) {
    all.push_back({title, text});
  }
  all.push_back({"seconds[s]", number(part.seconds.total)});
  return all;
}

std::string row(const std::vector<Field>& columns, std::string Field::*cell) {
  std::string line;
  for (const Field& column : columns) {
    if (&column != &columns.front()) line += ",";
    line += csv_field(column.*cell);
  }
  return line + "\r\n";
}

}  // namespace

std::string parts_csv(const CheckReport& report) {
  std::string csv = row(fields({}), &Field::title);
  for (const assessment::PartResult& part : report.parts) {
    csv += row(fields(part), &Field::text);
  }
  return csv;
}

}  // namespace clevis::report
