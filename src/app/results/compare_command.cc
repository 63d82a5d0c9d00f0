#include "app/results/compare_command.h"

#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>
#include <unistd.h>

#include "base/messages/errors.h"
#include "report/compare/comparison.h"
#include "report/compare/comparison_output.h"
#include "report/compare/result_reader.h"
#include "report/text/atomic_file.h"
#include "report/text/terminal.h"

namespace clevis::app {
namespace {

/// Defaults, then what the baseline brings, then the command line.
report::Tolerances tolerances_of(const CompareOptions& options,
                                 const report::StoredResult& baseline) {
  report::Tolerances tolerances;
  for (const auto& [quantity, text] : baseline.tolerances) {
    tolerances.set(quantity, text, "I003",
                   baseline.file.string() + ":/tolerances/" + quantity);
  }
  for (const std::string& option : options.tolerances) {
    const std::size_t equals = option.find('=');
    if (equals == std::string::npos) {
      throw Error("U001", "--tolerance", "\"" + option + "\" holds no '='",
                  "Write --tolerance NAME=VALUE, e.g. peak_von_mises=0.2%.");
    }
    tolerances.set(option.substr(0, equals), option.substr(equals + 1), "U001",
                   "--tolerance");
  }
  return tolerances;
}

}  // namespace

ExitCode compare_command(const CompareOptions& options) {
  const report::StoredResult result = report::read_result(options.result);
  const report::StoredResult baseline = report::read_result(options.baseline);
  const report::Comparison comparison =
      report::compare(result, baseline, tolerances_of(options, baseline));
  if (!options.junit.empty()) {
    report::write_file(options.junit, report::comparison_junit(comparison));
  }
  std::cout << (options.json
                    ? report::comparison_json(comparison)
                    : report::comparison_table(
                          comparison, report::colour_of(STDOUT_FILENO)));
  return report::is_regression(comparison) ? ExitCode::kRegression
                                           : ExitCode::kPass;
}

Run declare_compare(CLI::App& command) {
  const auto options = std::make_shared<CompareOptions>();
  command.add_option("RESULT", options->result, "result.json or its folder")
      ->required();
  command.add_option("BASELINE", options->baseline, "what it should be")
      ->required();
  command
      .add_option("--tolerance", options->tolerances,
                  "QUANTITY=VALUE, e.g. peak_von_mises=0.2%; may be repeated")
      ->type_name("QUANTITY=VALUE")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command.add_option("--junit", options->junit, "write JUnit XML here")
      ->type_name("FILE");
  command.add_flag("--json", options->json,
                   "print one JSON document instead of a table");
  return [options] {
    return compare_command(*options);
  };
}

}  // namespace clevis::app
