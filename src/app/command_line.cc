#include "app/command_line.h"

#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/command_list.h"
#include "scene/text/name_index.h"
#include "scene/text/suggestion.h"

namespace clevis::app {
namespace {

/// In lines, as a remedy cannot be.
constexpr std::string_view kFirstSteps =
    R"(error[U001]: command line: no command is given
  help: From nothing to a verdict:
    clevis init link                              # a scene to start from
    clevis check --mesh --report link/scene.toml  # does it hold? with a page to look at
    clevis --help                                 # all commands
)";

constexpr const char* kAbout =
    R"(clevis checks whether the link parts of a mechanism hold.

Examples:
  clevis init link                              # a scene to start from
  clevis check --mesh --report link/scene.toml  # does it hold? with a page to look at
  clevis init part --geometry FILE.step         # a scene of a part of your own
)";

constexpr const char* kExitCodes =
    R"(Exit codes: 0 pass, 1 a limit is exceeded, 2 usage, 3 regression, 4 not judged,
  10 scene invalid, 11 mesh invalid, 12 model invalid, 20 solver failed,
  21 resource limit, 22 files, 70 internal error. `clevis explain CODE` explains
  a diagnostic, `clevis explain` lists them all.)";

/// Remedy for a command line that the parser refuses.
std::string usage_remedy(const CLI::App& app, int argc,
                         const char* const* argv) {
  const auto chosen = app.get_subcommands();
  if (!chosen.empty()) {
    return "See clevis " + chosen.front()->get_name() + " --help.";
  }
  std::vector<std::string_view> names;
  for (const Command& command : commands()) names.emplace_back(command.name);
  return (argc > 1 ? scene::suggestion(argv[1], names) + " " : "") +
         "See clevis --help.";
}

}  // namespace

ExitCode run_command_line(int argc, const char* const* argv) {
  if (argc < 2) {
    std::cerr << kFirstSteps;
    return ExitCode::kUsage;
  }
  CLI::App app(kAbout, "clevis");
  app.footer(kExitCodes);
  app.set_version_flag("--version", "clevis " CLEVIS_VERSION);
  app.require_subcommand(1);
  Run run;
  for (const Command& command : commands()) {
    CLI::App* parser = app.add_subcommand(command.name, command.about);
    parser->callback([&run, declared = command.declare(*parser)] {
      run = declared;
    });
  }
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
  return run();
}

}  // namespace clevis::app
