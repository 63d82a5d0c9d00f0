#include "report/motion/motion_files.h"

#include <string>

#include "report/forces/element_output.h"
#include "report/machine/bearing_output.h"
#include "report/motion/motion_csv.h"
#include "report/motion/motion_json.h"
#include "report/summary/impact_output.h"
#include "report/text/atomic_file.h"

namespace clevis::report {

void write_motion_files(const MotionReport& report,
                        const std::filesystem::path& folder) {
  const std::string json = motion_json(report);  // refuses first
  write_file(folder / "reactions.csv", reactions_csv(report));
  write_file(folder / "motion.csv", motion_csv(report));
  if (!report.definition.elements.empty()) {
    write_file(folder / "forces.csv", forces_csv(report));
    write_file(folder / "events.csv", events_csv(report));
    write_file(folder / "impacts.csv",
               impacts_csv(named_impacts(report.definition, report.motion)));
  }
  if (!report.bearings.empty()) {
    write_file(folder / "bearings.csv", bearings_csv(report.bearings));
  }
  write_file(folder / "simulate.json", json);
}

}  // namespace clevis::report
