#include "app/commands/impact_command.h"

#include <iostream>

#include <CLI/CLI.hpp>
#include <unistd.h>

#include "base/messages/errors.h"
#include "beam/estimates/ejector.h"
#include "report/machine/ejector_output.h"
#include "scene/scene.h"

namespace clevis::app {

ExitCode impact_command(const Options& options) {
  const scene::Scene scene = scene::read_scene(options.scene, options.settings);
  if (scene.ejectors.empty()) {
    throw Error("S003", options.scene.string() + ":1:1",
                "the scene has no [[ejector]]",
                "Add one; docs/scene.md describes it. Blows on parts are "
                "checked by clevis check.");
  }
  report::EjectorReport report;
  report.version = CLEVIS_VERSION;
  report.scene = scene.name;
  for (const auto& ejector : scene.ejectors) {
    report.ejectors.push_back(report::ejector_result(ejector));
  }
  if (!options.out.empty()) {
    report::write_ejector_files(report, options.out);
  }
  std::cout << (options.json ? report::ejector_json(report)
                             : report::ejector_text(
                                   report, report::colour_of(STDOUT_FILENO)));
  return ExitCode::kPass;
}

Run declare_impact(CLI::App& command) {
  const auto request = std::make_shared<SceneRequest>();
  add_scene(command, *request);
  add_output(command, request->options);
  return run_request(request, impact_command);
}

}  // namespace clevis::app
