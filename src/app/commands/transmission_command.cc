#include "app/commands/transmission_command.h"

#include <iostream>

#include <CLI/CLI.hpp>
#include <unistd.h>

#include "base/messages/errors.h"
#include "machine/transmissions/transmission.h"
#include "report/machine/transmission_output.h"
#include "scene/scene.h"

namespace clevis::app {

ExitCode transmission_command(const Options& options) {
  const scene::Scene scene = scene::read_scene(options.scene, options.settings);
  if (scene.transmissions.empty()) {
    throw Error("S003", options.scene.string() + ":1:1",
                "the scene has no [[transmission]]",
                "Add one; docs/scene.md describes it.");
  }
  report::TransmissionReport report;
  report.version = CLEVIS_VERSION;
  report.scene = scene.name;
  for (const auto& transmission : scene.transmissions) {
    report.transmissions.push_back(machine::analyse_transmission(transmission));
  }
  if (!options.out.empty()) {
    report::write_transmission_files(report, options.out);
  }
  std::cout << (options.json ? report::transmission_json(report)
                             : report::transmission_text(
                                   report, report::colour_of(STDOUT_FILENO)));
  return ExitCode::kPass;
}

Run declare_transmission(CLI::App& command) {
  const auto request = std::make_shared<SceneRequest>();
  add_scene(command, *request);
  add_output(command, request->options);
  return run_request(request, transmission_command);
}

}  // namespace clevis::app
