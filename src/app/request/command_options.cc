#include "app/request/command_options.h"

#include <limits>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "assessment/job/model_traits.h"
#include "base/messages/errors.h"
#include "base/values/quantity.h"
#include "elasticity/problem/engine.h"
#include "scene/variants/setting.h"

namespace clevis::app {

CLI::Option* repeatable(CLI::Option* option, const std::string& type_name) {
  return option->type_name(type_name)
      ->expected(1)
      ->allow_extra_args(false)  // what follows may be the scene
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void add_scene(CLI::App& command, SceneRequest& request) {
  command.add_option("SCENE", request.options.scene, "the scene's .toml file")
      ->required();
  repeatable(command.add_option("--set", request.settings,
                                "a value in place of the scene's, e.g. "
                                "part.AB.thickness=\"10 mm\"; may be repeated"),
             "PATH=VALUE");
}

void add_parts(CLI::App& command, std::vector<std::string>& parts) {
  repeatable(
      command.add_option("--part", parts, "only this part; may be repeated"),
      "NAME");
}

void add_jobs(CLI::App& command, int& jobs, const char* help) {
  constexpr int kMostJobs = 1024;
  command.add_option("--jobs", jobs, help)
      ->type_name("N")
      ->check(CLI::Range(1, kMostJobs));
}

void add_output(CLI::App& command, Options& options) {
  command
      .add_option("--out", options.out,
                  "folder of the results [results/<scene>]")
      ->type_name("DIR");
  command.add_flag("--json", options.json,
                   "print one JSON document instead of tables");
}

void add_report_flag(CLI::App& command, Options& options) {
  command.add_flag("--report", options.report,
                   "write report.html, the result to look at in a browser");
}

void add_mesh_flag(CLI::App& command, Options& options) {
  command.add_flag("--mesh", options.mesh,
                   "first mesh the parts whose mesh is missing or outdated");
}

void add_max_time(CLI::App& command, SceneRequest& request) {
  command
      .add_option("--max-time", request.max_time,
                  "processor time that a motion may take, e.g. \"10 "
                  "min\" [60 s]; where it is given, no part is meshed finer "
                  "once it was checked for as long")
      ->type_name("TIME");
}

void add_max_dofs(CLI::App& command, Options& options, const char* help) {
  constexpr int kFewest = 100;
  command.add_option("--max-dofs", options.max_dofs, help)
      ->type_name("N")
      ->check(CLI::Range(kFewest, std::numeric_limits<int>::max()));
}

void add_engine(CLI::App& command, Options& options) {
  const std::vector<std::string> words(elasticity::kEngineWords.begin(),
                                       elasticity::kEngineWords.end());
  command
      .add_option("--engine", options.engine,
                  fmt::format("who solves plane stress and 3-D: {} [auto]",
                              fmt::join(words, ", ")))
      ->type_name("ENGINE")
      ->check(CLI::IsMember(words));
}

void add_model(CLI::App& command, std::string& model) {
  std::vector<std::string> words{"auto"};
  for (const auto& entry : assessment::kModels) words.emplace_back(entry.word);
  command
      .add_option(
          "--model", model,
          fmt::format("force a model: {} [auto]", fmt::join(words, ", ")))
      ->type_name("MODEL")
      ->check(CLI::IsMember(words));
}

void add_elements(CLI::App& command, Options& options) {
  command
      .add_option("--elements", options.elements,
                  "CalculiX's hexahedra: C3D20R or C3D20 [C3D20R]; "
                  "tetrahedra are C3D10")
      ->type_name("TYPE")
      ->check(CLI::IsMember({"C3D20R", "C3D20"}));
}

void add_split(CLI::App& command, Options& options, const char* help) {
  constexpr int kMostCuts = 8;
  command.add_option("--split", options.split, help)
      ->type_name("N")
      ->check(CLI::Range(1, kMostCuts));
}

double peak_tolerance(const std::string& text) {
  constexpr double kLeast = 1e-5, kMost = 0.5;
  double value{};
  try {
    value = parse_quantity(text, Dimension::kRatio, "--tolerance");
  } catch (const Error& refused) {
    throw Error("U001", refused.place(), refused.problem(), refused.remedy());
  }
  if (!(kLeast <= value && value <= kMost)) {
    throw Error("U001", "--tolerance", "\"" + text + "\" is out of range",
                "Give 0.001% to 50%.");
  }
  return value;
}

namespace {

double max_time(const std::string& text) {
  constexpr double kLeast = 0.1, kMost = 1e7;
  double value{};
  try {
    value = parse_quantity(text, Dimension::kTime, "--max-time");
  } catch (const Error& refused) {
    throw Error("U001", refused.place(), refused.problem(), refused.remedy());
  }
  if (!(kLeast <= value && value <= kMost)) {
    throw Error("U001", "--max-time", "\"" + text + "\" is out of range",
                "Give 0.1 s to 1e7 s.");
  }
  return value;
}

}  // namespace

Run run_request(std::shared_ptr<SceneRequest> request,
                ExitCode (*command)(const Options&)) {
  return [request = std::move(request), command] {
    Options& options = request->options;
    for (const std::string& text : request->settings) {
      options.settings.push_back(scene::parse_setting(
          text, fmt::format("--set {}", options.settings.size() + 1)));
    }
    if (request->tolerance) {
      options.tolerance = peak_tolerance(*request->tolerance);
    }
    if (request->max_time) options.max_time = max_time(*request->max_time);
    return command(options);
  };
}

}  // namespace clevis::app
