#include "report/check/parts_csv.h"

#include "report/parts/impact_quantities.h"
#include "report/parts/part_quantities.h"
#include "report/quantities/quantity_csv.h"

namespace clevis::report {
namespace {

std::vector<CsvCell> cells_of(const assessment::PartResult& part) {
  std::vector<CsvCell> cells;
  add_csv_cells(&part, part_quantities(), cells);
  add_csv_cells(computed_vibration(part), vibration_quantities(), cells);
  add_csv_cells(governing_blow(part), blow_quantities(), cells);
  return cells;
}

}  // namespace

std::string parts_csv(const CheckReport& report) {
  std::string csv = csv_line(cells_of({}), &CsvCell::title);
  for (const assessment::PartResult& part : report.parts) {
    csv += csv_line(cells_of(part), &CsvCell::text);
  }
  return csv;
}

}  // namespace clevis::report
