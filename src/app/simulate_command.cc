#include <iostream>

#include <unistd.h>

#include "app/commands.h"
#include "app/load_scene.h"
#include "app/output_folder.h"
#include "app/plugin_commands.h"
#include "app/slide_lever_comparison.h"
#include "app/view_inputs.h"
#include "machine/bearing_life.h"
#include "mechanism/simulate.h"
#include "mechanism/structure/structure.h"
#include "report/motion/motion_files.h"
#include "report/motion/motion_json.h"
#include "report/motion/motion_table.h"
#include "report/page/report_page.h"
#include "report/summary/motion_report.h"
#include "report/text/terminal.h"
#include "report/view/view_files.h"

namespace clevis::app {
namespace {

/// Tables, what a report reads, and that if it is asked for.
void write_files(const scene::Scene& scene, const report::MotionReport& motion,
                 const Options& options) {
  if (options.out.empty() && !options.report) return;
  const std::filesystem::path folder = output_folder(options);
  report::write_motion_view({.version = motion.version,
                             .scene = motion.scene,
                             .inputs = view_inputs(scene),
                             .definition = motion.definition,
                             .motion = motion.motion,
                             .worst_times = {}},
                            folder, report::ResultKind::kSimulation);
  report::write_motion_files(motion, folder);
  if (options.report)
    report::write_report(folder, report::ResultKind::kSimulation);
}

}  // namespace

ExitCode simulate_command(const Options& options) {
  scene::Scene scene = load_moving_scene(options.scene);
  if (!scene.has_mechanism) {
    throw Error("S003", options.scene.string() + ":1:1",
                "the scene has no [[body]], so there is nothing to move",
                "Add a mechanism, or run clevis check.");
  }
  if (scene.simulation.links == mechanism::LinkStiffness::kElastic) {
    add_link_compliances_by_plugin(scene, options);
  }
  report::MotionReport report;
  report.version = CLEVIS_VERSION;
  report.scene = scene.name;
  report.definition = scene.mechanism;
  report.structure = mechanism::analyse_structure(scene.mechanism);
  mechanism::SimulationSettings settings = scene.simulation;
  settings.at_peaks = true;
  report.motion = mechanism::simulate(scene.mechanism, settings);
  if (scene.slide_lever) {
    report.slide_lever = compare_slide_lever(scene, report.motion);
  }
  report.bearings = report::bearing_reports(
      machine::judge_bearings(scene.bearings, scene.mechanism, report.motion),
      scene.mechanism);
  write_files(scene, report, options);
  std::cout << (options.json ? report::motion_json(report)
                             : report::motion_table(
                                   report, report::colour_of(STDOUT_FILENO)));
  return ExitCode::kPass;
}

}  // namespace clevis::app
