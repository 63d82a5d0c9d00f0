#include "app/results/compare_command.h"

#include <iostream>

#include <unistd.h>

#include "base/errors.h"
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

}  // namespace clevis::app
