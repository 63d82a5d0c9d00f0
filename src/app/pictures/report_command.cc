#include "app/pictures/report_command.h"

#include <iostream>

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

}  // namespace clevis::app
