#include "app/commands/simulate_command.h"

#include <iostream>
#include <optional>

#include <CLI/CLI.hpp>
#include <unistd.h>

#include "app/commands/slide_lever_comparison.h"
#include "app/plugin/solver_library.h"
#include "app/processes/folder_lock.h"
#include "app/request/output_folder.h"
#include "app/scenes/load_scene.h"
#include "app/scenes/mesh_parts.h"
#include "app/scenes/motion_of_scene.h"
#include "app/scenes/view_inputs.h"
#include "base/messages/errors.h"
#include "machine/bearings/bearing_life.h"
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
  const std::filesystem::path folder = output_folder(options);
  report::write_motion_view({.version = motion.version,
                             .scene = motion.scene,
                             .inputs = view_inputs(scene),
                             .definition = motion.definition,
                             .motion = motion.motion,
                             .worst_times = {}},
                            folder, report::ResultKind::kSimulation);
  report::write_motion_files(motion, folder);
  if (options.report) {
    tell_report(report::write_report(folder, report::ResultKind::kSimulation));
  }
}

}  // namespace

ExitCode simulate_command(const Options& options) {
  scene::Scene scene = scene::read_scene(options.scene, options.settings);
  if (!scene.has_mechanism) {
    throw Error("S003", options.scene.string() + ":1:1",
                "the scene has no [[body]], so there is nothing to move",
                "Add a mechanism, or run clevis check.");
  }
  if (options.mesh) mesh_parts(options, MeshWhich::kOutdated, std::cerr);
  mesh_solids(scene, std::cerr);
  load_masses(scene);
  if (scene.simulation.links == mechanism::LinkStiffness::kElastic) {
    add_link_compliances_by_plugin(scene);
  }
  std::optional<FolderLock> lock;
  if (!options.out.empty() || options.report) {
    lock.emplace(output_folder(options));
  }
  report::MotionReport report;
  report.version = CLEVIS_VERSION;
  report.scene = scene.name;
  report.definition = scene.mechanism;
  report.structure = mechanism::analyse_structure(scene.mechanism);
  report.motion = motion_of_scene(scene, options);
  if (scene.slide_lever) {
    report.slide_lever = compare_slide_lever(scene, report.motion);
  }
  report.bearings = report::bearing_reports(
      machine::judge_bearings(scene.bearings, scene.mechanism, report.motion),
      scene.mechanism);
  if (lock) write_files(scene, report, options);
  std::cout << (options.json ? report::motion_json(report)
                             : report::motion_table(
                                   report, report::colour_of(STDOUT_FILENO)));
  return ExitCode::kPass;
}

Run declare_simulate(CLI::App& command) {
  const auto request = std::make_shared<SceneRequest>();
  add_scene(command, *request);
  add_output(command, request->options);
  add_report_flag(command, request->options);
  add_max_time(command, *request);
  add_mesh_flag(command, request->options);
  return run_request(request, simulate_command);
}

}  // namespace clevis::app
