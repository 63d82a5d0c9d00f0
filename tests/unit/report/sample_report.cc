#include "sample_report.h"

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "part/verdict.h"

namespace clevis::report {

using assessment::PeakVerdict;

assessment::PartResult sample_part(const std::string& name) {
  assessment::PartResult part;
  part.name = name;
  part.verdict = part::Verdict::kPass;
  part.why = "safety factor 2.84 >= 1.5";
  part.model = "plane stress, p = 4";
  part.dofs = 4758;
  part.cells = 137;
  part.load_columns = 15;
  part.engine = "own";
  part.peak = {.value = 125e6,
               .band_low = 124.5e6,
               .band_high = 125.75e6,
               .shares = {.mesh = 0.5e6, .time = 0.25e6},
               .verdict = PeakVerdict::kConverged,
               .at = {0.0125, -0.003, 0.004},
               .group = "bore_C",
               .instant = 1.25,
               .label = "t = 1.25 s",
               .sequence = {{2, 1000, 120e6, 6.5e-3, "t = 1.25 s"},
                            {3, 2746, 124e6, 6.6e-3, "t = 1.25 s"}}};
  part.safety_factor = 2.84;
  part.deflection = 0.125e-3;
  part.deflection_low = 0.124e-3;
  part.deflection_high = 0.127e-3;
  part.deflection_at = {0.1, 0.02, -0.005};
  part.deflection_instant = 0.75;
  part.strain_energy = 6.65709e-3;
  part.strain_energy_instant = 1.5;
  part.mean_strain_energy = 2.5e-3;
  part.beam = {.peak_stress = 100e6,
               .governing = "lug E net section",
               .deflection = 0.11e-3,
               .buckling_safety = 12.5,
               .ratio_fe_to_beam = 1.25,
               .reason = "curved eye"};
  part.self_checks = {1e-12, 2e-13, 3e-14, 4e-7, true};
  part.probes = {{"D", "stress_yy", 5.5e6, 5.4e6, 5.6e6},
                 {"T", "displacement_x", 1.5e-5, 1.4e-5, 1.6e-5}};
  part.seconds = {0.01, 0.005, 0.02, 0.03, 0.04, 0.05, 0.06, 0.21};
  part.mass = 0.75;
  return part;
}

CheckReport sample_report() {
  CheckReport report;
  report.version = "0.1.0";
  report.scene = "landing gear";
  report.file = "geometry/landing_gear/scene.toml";
  report.mechanism = MechanismSummary{
      .mobility = 1,
      .redundant_constraints = 0,
      .instants = 201,
      .max_closure_error = 2e-16,
      .max_power_balance_error = 3e-13,
      .not_unique = {},
      .joints = {{"D", {2970.5, 0.5}, {0.0, 0.0}}, {"E", {609.25, 2.0}, {}}},
      .drives = {{"cylinder", EffortKind::kForce, {5029.0, 2.0}},
                 {"screw", EffortKind::kTorque, {12.5, 1.0}}}};
  report.parts = {sample_part("DCE"), sample_part("BC")};
  report.limits["DCE"] = {
      .safety_factor = 1.5, .deflection = 0.5e-3, .buckling = {}};
  report.seconds = {{"simulate", 0.02}, {"parts", 3.0}, {"total", 3.1}};
  return report;
}

TestFolder::TestFolder() {
  std::string pattern =
      (std::filesystem::temp_directory_path() / "clevis-report-XXXXXX")
          .string();
  path_ = ::mkdtemp(pattern.data());
}

TestFolder::~TestFolder() {
  std::filesystem::remove_all(path_);
}

std::string content_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream content;
  content << stream.rdbuf();
  return content.str();
}

}  // namespace clevis::report
