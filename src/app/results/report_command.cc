#include "app/results/report_command.h"

#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>

#include "report/page/report_page.h"
#include "report/text/atomic_file.h"

namespace clevis::app {

ExitCode report_command(const ReportOptions& options) {
  const auto kind = report::result_kind(options.result);
  if (options.file.empty()) {
    std::cout << report::write_report(options.result, kind).string() << "\n";
  } else {
    report::write_file(
        options.file,
        report::report_page(report::read_result_folder(options.result, kind)));
    std::cout << options.file.string() << "\n";
  }
  return ExitCode::kPass;
}

Run declare_report(CLI::App& command) {
  command.footer(
      "Reads what `clevis check` or `clevis simulate --out` wrote. The file "
      "opens in\nany browser, from disk, and loads nothing from elsewhere.");
  const auto options = std::make_shared<ReportOptions>();
  command.add_option("RESULT_DIR", options->result, "folder of the result")
      ->required();
  command
      .add_option("--out", options->file, "the file [RESULT_DIR/report.html]")
      ->type_name("FILE");
  return [options] {
    return report_command(*options);
  };
}

}  // namespace clevis::app
