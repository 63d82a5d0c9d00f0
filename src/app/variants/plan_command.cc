#include "app/variants/plan_command.h"

#include <cerrno>
#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/request/output_folder.h"
#include "app/request/shell_word.h"
#include "app/scenes/geometry_constants.h"
#include "app/variants/check_inputs.h"
#include "base/bytes/fingerprint.h"
#include "base/messages/errors.h"
#include "report/text/atomic_file.h"
#include "report/variants/plan_file.h"
#include "scene/scene.h"
#include "scene/variants/design.h"
#include "scene/variants/variant_list.h"

namespace clevis::app {
namespace {

std::vector<scene::Variant> wanted_variants(const PlanOptions& options,
                                            const scene::Scene& scene) {
  if (!options.vary.empty()) return scene::read_variant_list(options.vary);
  if (scene.vary) return scene::variants_of(*scene.vary);
  throw Error("S003", options.scene.string() + ":1:1",
              "the scene has no [vary] that says which variants are wanted",
              "Add one, or give a table of variants with --vary.");
}

/// Refuses a variant as its check would.
scene::Scene readable(const PlanOptions& options,
                      const scene::Variant& variant) {
  scene::Scene scene = scene::read_scene(options.scene, variant.settings);
  for (std::size_t p = 0; p < scene.parts.size(); ++p) {
    require_constants(scene.parts[p].geometry, scene.inputs[p].parameters);
  }
  return scene;
}

report::PlannedVariant planned(const PlanOptions& options,
                               const scene::Variant& variant) {
  const scene::Scene scene = readable(options, variant);
  report::PlannedVariant result;
  result.name = variant.name;
  for (const scene::Setting& setting : variant.settings) {
    result.inputs.settings.emplace_back(setting.path, setting.value);
  }
  result.inputs.scene =
      fingerprint(scene::scene_content(options.scene, variant.settings));
  result.inputs.tolerance = options.tolerance;
  result.inputs.model = options.model;
  result.inputs.engine = "auto";
  result.inputs.parts = options.parts;
  result.inputs.geometries = geometry_fingerprints(scene);
  result.inputs.meshes = given_mesh_fingerprints(scene);
  return result;
}

/// One command that a shell takes as it stands.
std::string command_line(const PlanOptions& options,
                         const scene::Variant& variant,
                         const std::filesystem::path& folder) {
  std::vector<std::string> words{options.program, "check",
                                 options.scene.string()};
  for (const scene::Setting& setting : variant.settings) {
    words.insert(words.end(), {"--set", setting.path + "=" + setting.value});
  }
  for (const std::string& part : options.parts) {
    words.insert(words.end(), {"--part", part});
  }
  if (options.tolerance) {
    words.insert(words.end(), {"--tolerance", options.tolerance_text});
  }
  if (options.model != "auto") {
    words.insert(words.end(), {"--model", options.model});
  }
  words.insert(words.end(),
               {"--jobs", std::to_string(options.jobs), "--mesh", "--resume",
                "--out", (folder / variant.name).string()});
  for (std::string& word : words) word = shell_word(word);
  return fmt::format("{}\n", fmt::join(words, " "));
}

}  // namespace

ExitCode plan_command(const PlanOptions& options) {
  const scene::Scene scene = scene::read_scene(options.scene);
  const auto variants = wanted_variants(options, scene);
  const std::filesystem::path folder =
      options.out.empty()
          ? std::filesystem::path(results_folder(options.scene).string() +
                                  "_variants")
          : options.out;
  report::Plan plan{CLEVIS_VERSION, scene.name, options.scene, {}};
  std::string commands;
  for (const scene::Variant& variant : variants) {
    plan.variants.push_back(planned(options, variant));
    commands += command_line(options, variant, folder);
  }
  report::write_file(folder / report::kPlanFile, report::plan_json(plan));
  std::cout << commands;
  return ExitCode::kPass;
}

Run declare_plan(CLI::App& command) {
  command.footer(
      "Prints one command per line for GNU parallel, a cluster's scheduler or\n"
      "a loop, and writes the plan to --out for `clevis collect`. A command "
      "can\n"
      "be repeated: what is finished is skipped. docs/cluster.md has recipes.");
  const auto options = std::make_shared<PlanOptions>();
  options->program = program_invocation_name;
  command.add_option("SCENE", options->scene, "the scene's .toml file")
      ->required();
  command
      .add_option("--vary", options->vary,
                  "CSV of variants: a header of paths, a row for each [the "
                  "scene's table vary]")
      ->type_name("FILE");
  command
      .add_option("--out", options->out,
                  "folder of the variants [results/<scene>_variants]")
      ->type_name("DIR");
  add_parts(command, options->parts);
  const CLI::Option* tolerance =
      command
          .add_option("--tolerance", options->tolerance_text,
                      "of the peak stress, e.g. 5%; replaces the scene's")
          ->type_name("RATIO");
  add_model(command, options->model);
  add_jobs(command, options->jobs, "parts in parallel of each check [1]");
  return [options, tolerance] {
    if (tolerance->count() > 0) {
      options->tolerance = peak_tolerance(options->tolerance_text);
    }
    return plan_command(*options);
  };
}

}  // namespace clevis::app
