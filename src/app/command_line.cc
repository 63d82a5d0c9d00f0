#include "app/command_line.h"

#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/commands/explain_command.h"
#include "app/commands/faces_command.h"
#include "app/commands/impact_command.h"
#include "app/commands/mesh_command.h"
#include "app/commands/plugin_commands.h"
#include "app/commands/simulate_command.h"
#include "app/commands/transmission_command.h"
#include "app/request/options.h"
#include "app/results/compare_command.h"
#include "app/results/glb_command.h"
#include "app/results/report_command.h"
#include "app/start/completion.h"
#include "app/start/doctor_command.h"
#include "app/start/init_command.h"
#include "app/start/templates.h"
#include "app/variants/collect_command.h"
#include "app/variants/plan_command.h"
#include "assessment/job/model_traits.h"
#include "base/quantity.h"
#include "elasticity/problem/engine.h"
#include "scene/text/name_index.h"
#include "scene/text/suggestion.h"
#include "scene/variants/setting.h"

namespace clevis::app {
namespace {

constexpr const char* kAbout =
    R"(clevis checks whether the link parts of a mechanism hold.

Examples:
  clevis check geometry/landing_gear/scene.toml
  clevis simulate geometry/landing_gear/scene.toml --out results/gear
  clevis compare results/gear results/baselines/gear
)";

constexpr const char* kExitCodes =
    R"(Exit codes: 0 pass, 1 a limit is exceeded, 2 usage, 3 regression, 4 not judged,
  10 scene invalid, 11 mesh invalid, 12 model invalid, 20 solver failed,
  21 resource limit, 22 files, 70 internal error. `clevis explain CODE` explains
  a diagnostic, `clevis explain` lists them all.)";

/// What the parser fills in; lives as long as the parser.
struct Parsed {
  Options options;
  PlanOptions plan;
  CompareOptions compare;
  InitOptions init;
  std::string shell;               ///< of `completion`
  std::filesystem::path variants;  ///< folder that `collect` reads
  std::vector<std::string> settings;
  ReportOptions report;
  FacesOptions faces;
  std::string tolerance;
  std::string code;
  std::function<ExitCode()> run;
};

/// Relative tolerance of the peak stress from e.g. "1%"; a bare number may be
/// meant either way.
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

void add_scene(CLI::App& command, Parsed& parsed) {
  command.add_option("SCENE", parsed.options.scene, "the scene's .toml file")
      ->required();
  command
      .add_option("--set", parsed.settings,
                  "a value in place of the scene's, e.g. "
                  "part.AB.thickness=\"10 mm\"; may be repeated")
      ->type_name("PATH=VALUE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

/// Each --set with its number for messages.
void take_settings(Parsed& parsed) {
  for (const std::string& text : parsed.settings) {
    parsed.options.settings.push_back(scene::parse_setting(
        text, fmt::format("--set {}", parsed.options.settings.size() + 1)));
  }
}

void add_parts(CLI::App& command, std::vector<std::string>& parts) {
  command.add_option("--part", parts, "only this part; may be repeated")
      ->type_name("NAME")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void add_jobs(CLI::App& command, int& jobs, const char* help) {
  constexpr int kMostJobs = 1024;
  command.add_option("--jobs", jobs, help)
      ->type_name("N")
      ->check(CLI::Range(1, kMostJobs));
}

void add_output(CLI::App& command, Parsed& parsed) {
  command
      .add_option("--out", parsed.options.out,
                  "folder of the results [results/<scene>]")
      ->type_name("DIR");
  command.add_flag("--json", parsed.options.json,
                   "print one JSON document instead of tables");
}

void add_report_flag(CLI::App& command, Parsed& parsed) {
  command.add_flag("--report", parsed.options.report,
                   "write report.html, the result to look at in a browser");
}

void add_simulate(CLI::App& app, Parsed& parsed) {
  CLI::App* command = app.add_subcommand(
      "simulate", "the mechanism alone: structure, motion, reactions");
  add_scene(*command, parsed);
  add_output(*command, parsed);
  add_report_flag(*command, parsed);
  command->callback([&parsed] {
    parsed.run = [&parsed] {
      return simulate_command(parsed.options);
    };
  });
}

void add_transmission(CLI::App& app, Parsed& parsed) {
  CLI::App* command = app.add_subcommand(
      "transmission", "compliance, frequencies and error of drive trains");
  add_scene(*command, parsed);
  add_output(*command, parsed);
  command->callback([&parsed] {
    parsed.run = [&parsed] {
      return transmission_command(parsed.options);
    };
  });
}

void add_impact(CLI::App& app, Parsed& parsed) {
  CLI::App* command = app.add_subcommand(
      "impact", "ejectors by beam theory: blow on the workpiece, limits");
  add_scene(*command, parsed);
  add_output(*command, parsed);
  command->callback([&parsed] {
    parsed.run = [&parsed] {
      return impact_command(parsed.options);
    };
  });
}

std::vector<std::string> model_words() {
  std::vector<std::string> words{"auto"};
  for (const auto& model : assessment::kModels) words.emplace_back(model.word);
  return words;
}

std::string about_models() {
  std::string text =
      "auto takes the cheapest model that suits a part and meets the "
      "tolerance:";
  for (const auto& model : assessment::kModels) {
    text += fmt::format("\n  {:<13} {}", model.word, model.suits);
  }
  return text;
}

void add_engine(CLI::App& command, Parsed& parsed) {
  const std::vector<std::string> words(elasticity::kEngineWords.begin(),
                                       elasticity::kEngineWords.end());
  command
      .add_option("--engine", parsed.options.engine,
                  fmt::format("who solves plane stress and 3-D: {} [auto]",
                              fmt::join(words, ", ")))
      ->type_name("ENGINE")
      ->check(CLI::IsMember(words));
}

void add_model(CLI::App& command, std::string& model) {
  const auto words = model_words();
  command
      .add_option(
          "--model", model,
          fmt::format("force a model: {} [auto]", fmt::join(words, ", ")))
      ->type_name("MODEL")
      ->check(CLI::IsMember(words));
}

void add_check(CLI::App& app, Parsed& parsed) {
  CLI::App* command = app.add_subcommand(
      "check", "does every part hold over the motion and its cases?");
  add_scene(*command, parsed);
  add_parts(*command, parsed.options.parts);
  command
      ->add_option("--tolerance", parsed.tolerance,
                   "of the peak stress, e.g. 1%; replaces the scene's")
      ->type_name("RATIO");
  add_output(*command, parsed);
  add_report_flag(*command, parsed);
  add_jobs(*command, parsed.options.jobs, "parts in parallel [one per core]");
  add_model(*command, parsed.options.model);
  command->add_flag("--mesh", parsed.options.mesh,
                    "first mesh the parts whose mesh is missing or outdated");
  constexpr int kMostRounds = 5;
  command
      ->add_option("--mesh-rounds", parsed.options.mesh_rounds,
                   "finer meshes at most of a STEP part whose band stays open "
                   "[2]")
      ->type_name("N")
      ->check(CLI::Range(0, kMostRounds));
  command->add_flag("--resume", parsed.options.resume,
                    "keep the result in --out if it is whole and of the same "
                    "inputs");
  add_engine(*command, parsed);
  command->footer(about_models());
  command->callback([&parsed, command] {
    parsed.run = [&parsed, command] {
      if (command->count("--tolerance") > 0) {
        parsed.options.tolerance = peak_tolerance(parsed.tolerance);
      }
      return check_command(parsed.options);
    };
  });
}

void add_elements(CLI::App& command, Parsed& parsed) {
  command
      .add_option("--elements", parsed.options.elements,
                  "CalculiX's hexahedra: C3D20R or C3D20 [C3D20R]; "
                  "tetrahedra are C3D10")
      ->type_name("TYPE")
      ->check(CLI::IsMember({"C3D20R", "C3D20"}));
}

void add_split(CLI::App& command, Parsed& parsed, const char* help) {
  constexpr int kMostCuts = 8;
  command.add_option("--split", parsed.options.split, help)
      ->type_name("N")
      ->check(CLI::Range(1, kMostCuts));
}

void add_study(CLI::App& app, Parsed& parsed) {
  CLI::App* command = app.add_subcommand(
      "study", "speed against error: every model and degree, and CalculiX");
  command->footer(
      "Solves each part with every model and degree, one process at a time,\n"
      "and CalculiX's ccx beside them if it is installed. Tables (CSV), plots\n"
      "(SVG) and study.json go to --out.");
  add_scene(*command, parsed);
  add_parts(*command, parsed.options.parts);
  add_output(*command, parsed);
  add_elements(*command, parsed);
  add_split(*command, parsed,
            "cut CalculiX's hexahedra into up to N x N x N [6]");
  command->add_flag("--every-instant", parsed.options.every_instant,
                    "CalculiX solves all instants, a step for each, not only "
                    "the governing one");
  add_engine(*command, parsed);
  command->callback([&parsed] {
    parsed.run = [&parsed] {
      return study_command(parsed.options);
    };
  });
}

void add_modes(CLI::App& app, Parsed& parsed) {
  constexpr int kMostModes = 200;
  CLI::App* command = app.add_subcommand(
      "modes", "free vibrations of the parts: frequencies and shapes");
  command->footer(
      "A part that the mechanism moves vibrates free, with 6 rigid modes; a\n"
      "case's supports give modes of their own. Shapes (VTU) and modes.json "
      "go\n"
      "to --out [results/<scene>/modes].");
  add_scene(*command, parsed);
  add_parts(*command, parsed.options.parts);
  command
      ->add_option("--modes", parsed.options.modes,
                   "how many per part, rigid ones counted in [12]")
      ->type_name("N")
      ->check(CLI::Range(1, kMostModes));
  command
      ->add_option("--tolerance", parsed.tolerance,
                   "of the frequencies, e.g. 1%")
      ->type_name("RATIO");
  add_output(*command, parsed);
  command->callback([&parsed, command] {
    parsed.run = [&parsed, command] {
      if (command->count("--tolerance") > 0) {
        parsed.options.tolerance = peak_tolerance(parsed.tolerance);
      }
      return modes_command(parsed.options);
    };
  });
}

void add_export(CLI::App& app, Parsed& parsed) {
  CLI::App* command = app.add_subcommand(
      "export", "the parts as CalculiX decks, or a result as glTF");
  command->footer(
      "Without --glb a deck per part, one step per instant. With --glb the "
      "moving,\ncoloured parts of a check that has run as mechanism.glb; SCENE "
      "may be the\nfolder of its result.");
  add_scene(*command, parsed);
  add_parts(*command, parsed.options.parts);
  add_output(*command, parsed);
  add_elements(*command, parsed);
  add_split(*command, parsed, "cut each hexahedron into N x N x N [1]");
  command->add_flag("--glb", parsed.options.glb,
                    "write mechanism.glb from the result of the check");
  command->callback([&parsed] {
    parsed.run = [&parsed] {
      return parsed.options.glb ? glb_command(parsed.options)
                                : export_command(parsed.options);
    };
  });
}

void add_mesh(CLI::App& app, Parsed& parsed) {
  CLI::App* command =
      app.add_subcommand("mesh", "(re)build the meshes from geometry/");
  command->footer(
      "Runs gmsh on the .geo files that the scene names. A .geo can run shell\n"
      "commands: mesh only scenes that you trust. No other command runs them,\n"
      "but `check` with --mesh; they read the .msh. STEP, IGES and BREP files\n"
      "run nothing: every command that needs their meshes makes them.");
  add_scene(*command, parsed);
  add_parts(*command, parsed.options.parts);
  command->callback([&parsed] {
    parsed.run = [&parsed] {
      return mesh_command(parsed.options);
    };
  });
}

void add_faces(CLI::App& app, Parsed& parsed) {
  CLI::App* command =
      app.add_subcommand("faces", "the faces of a STEP, IGES or BREP solid");
  command->footer(
      "Number, type, diameter, place, axis or normal, area and neighbours of "
      "every\nface; of a scene's parts also the groups that joints and "
      "selectors find.");
  command
      ->add_option("FILE", parsed.faces.file,
                   "a .step, .stp, .iges, .igs or .brep file, or a scene")
      ->required();
  command->add_option("PART", parsed.faces.part,
                      "of the scene; default: all parts that are solids");
  command->add_flag("--json", parsed.faces.json,
                    "print one JSON document instead of tables");
  command->callback([&parsed] {
    parsed.run = [&parsed] {
      return faces_command(parsed.faces);
    };
  });
}

void add_report(CLI::App& app, Parsed& parsed) {
  CLI::App* command = app.add_subcommand(
      "report", "a result as one HTML file to look at and pass on");
  command->footer(
      "Reads what `clevis check` or `clevis simulate --out` wrote. The file "
      "opens in\nany browser, from disk, and loads nothing from elsewhere.");
  command
      ->add_option("RESULT_DIR", parsed.report.result, "folder of the result")
      ->required();
  command
      ->add_option("--out", parsed.report.file,
                   "the file [RESULT_DIR/report.html]")
      ->type_name("FILE");
  command->callback([&parsed] {
    parsed.run = [&parsed] {
      return report_command(parsed.report);
    };
  });
}

void add_plan(CLI::App& app, Parsed& parsed) {
  PlanOptions& options = parsed.plan;
  CLI::App* command = app.add_subcommand(
      "plan", "commands that check many variants of a scene");
  command->footer(
      "Prints one command per line for GNU parallel, a cluster's scheduler or\n"
      "a loop, and writes the plan to --out for `clevis collect`. A command "
      "can\n"
      "be repeated: what is finished is skipped. docs/cluster.md has recipes.");
  command->add_option("SCENE", options.scene, "the scene's .toml file")
      ->required();
  command
      ->add_option("--vary", options.vary,
                   "CSV of variants: a header of paths, a row for each [the "
                   "scene's table vary]")
      ->type_name("FILE");
  command
      ->add_option("--out", options.out,
                   "folder of the variants [results/<scene>_variants]")
      ->type_name("DIR");
  add_parts(*command, options.parts);
  command
      ->add_option("--tolerance", options.tolerance_text,
                   "of the peak stress, e.g. 5%; replaces the scene's")
      ->type_name("RATIO");
  add_model(*command, options.model);
  add_jobs(*command, options.jobs, "parts in parallel of each check [1]");
  command->callback([&parsed, command] {
    parsed.run = [&parsed, command] {
      if (command->count("--tolerance") > 0) {
        parsed.plan.tolerance = peak_tolerance(parsed.plan.tolerance_text);
      }
      return plan_command(parsed.plan);
    };
  });
}

void add_collect(CLI::App& app, Parsed& parsed) {
  CLI::App* command = app.add_subcommand(
      "collect", "the results of a plan: table, plot, lightest that passes");
  command
      ->add_option("DIR", parsed.variants,
                   "folder that the plan was written "
                   "to")
      ->required();
  command->callback([&parsed] {
    parsed.run = [&parsed] {
      return collect_command(parsed.variants);
    };
  });
}

void add_compare(CLI::App& app, Parsed& parsed) {
  CLI::App* command =
      app.add_subcommand("compare", "regression check against a baseline");
  CompareOptions& options = parsed.compare;
  command->add_option("RESULT", options.result, "result.json or its folder")
      ->required();
  command->add_option("BASELINE", options.baseline, "what it should be")
      ->required();
  command
      ->add_option("--tolerance", options.tolerances,
                   "QUANTITY=VALUE, e.g. peak_von_mises=0.2%; may be repeated")
      ->type_name("QUANTITY=VALUE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command->add_option("--junit", options.junit, "write JUnit XML here")
      ->type_name("FILE");
  command->add_flag("--json", options.json,
                    "print one JSON document instead of a table");
  command->callback([&parsed] {
    parsed.run = [&parsed] {
      return compare_command(parsed.compare);
    };
  });
}

void add_explain(CLI::App& app, Parsed& parsed) {
  CLI::App* command =
      app.add_subcommand("explain", "what a diagnostic means and what to do");
  command->add_option("CODE", parsed.code, "e.g. S004; none lists all");
  command->callback([&parsed] {
    parsed.run = [&parsed] {
      return explain_command(parsed.code);
    };
  });
}

void add_init(CLI::App& app, Parsed& parsed) {
  CLI::App* command =
      app.add_subcommand("init", "write a commented scene that runs");
  std::vector<std::string> words;
  std::string about = "Templates:";
  for (const Template& entry : templates()) {
    words.emplace_back(entry.word);
    about += fmt::format("\n  {:<13} {}", entry.word, entry.about);
  }
  command->footer(about);
  command->add_option("NAME", parsed.init.folder, "folder to make")->required();
  command
      ->add_option("--template", parsed.init.template_word,
                   fmt::format("{} [part]", fmt::join(words, ", ")))
      ->type_name("TEMPLATE")
      ->check(CLI::IsMember(words));
  command->callback([&parsed] {
    parsed.run = [&parsed] {
      return init_command(parsed.init);
    };
  });
}

void add_doctor(CLI::App& app, Parsed& parsed) {
  app.add_subcommand("doctor", "what is installed, and what it is needed for")
      ->callback([&parsed] {
        parsed.run = doctor_command;
      });
}

void add_completion(CLI::App& app, Parsed& parsed) {
  CLI::App* command =
      app.add_subcommand("completion", "completion of commands in a shell");
  command->footer(
      "bash: clevis completion bash > ~/.local/share/bash-completion/"
      "completions/clevis\n"
      "zsh:  clevis completion zsh > DIR/_clevis, DIR a folder of $fpath\n"
      "fish: clevis completion fish > ~/.config/fish/completions/clevis.fish");
  command->add_option("SHELL", parsed.shell, "bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  command->callback([&app, &parsed] {
    parsed.run = [&app, &parsed] {
      std::cout << completion(app, parsed.shell);
      return ExitCode::kPass;
    };
  });
}

/// What to do about a command line that the parser refuses.
std::string usage_remedy(const CLI::App& app, int argc,
                         const char* const* argv) {
  const auto chosen = app.get_subcommands();
  if (!chosen.empty()) {
    return "See clevis " + chosen.front()->get_name() + " --help.";
  }
  std::vector<std::string_view> names;
  for (const CLI::App* command : app.get_subcommands({})) {
    names.push_back(command->get_name());
  }
  return (argc > 1 ? scene::suggestion(argv[1], names) + " " : "") +
         "See clevis --help.";
}

}  // namespace

ExitCode run_command_line(int argc, const char* const* argv) {
  CLI::App app(kAbout, "clevis");
  app.footer(kExitCodes);
  app.set_version_flag("--version", "clevis " CLEVIS_VERSION);
  app.require_subcommand(1);
  Parsed parsed;
  if (argc > 0) parsed.plan.program = argv[0];
  add_check(app, parsed);
  add_simulate(app, parsed);
  add_transmission(app, parsed);
  add_impact(app, parsed);
  add_mesh(app, parsed);
  add_faces(app, parsed);
  add_study(app, parsed);
  add_modes(app, parsed);
  add_export(app, parsed);
  add_plan(app, parsed);
  add_collect(app, parsed);
  add_report(app, parsed);
  add_compare(app, parsed);
  add_explain(app, parsed);
  add_init(app, parsed);
  add_doctor(app, parsed);
  add_completion(app, parsed);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& outcome) {
    if (outcome.get_exit_code() == 0) {  // --help, --version
      app.exit(outcome);
      return ExitCode::kPass;
    }
    throw Error("U001", "command line", outcome.what(),
                usage_remedy(app, argc, argv));
  }
  take_settings(parsed);
  return parsed.run();
}

}  // namespace clevis::app
