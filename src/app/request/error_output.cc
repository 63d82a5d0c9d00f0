#include "app/request/error_output.h"

#include <iostream>
#include <string>

#include <unistd.h>

#include "app/request/error_text.h"
#include "report/text/terminal.h"

namespace clevis::app {

void print_error(const Error& error, ErrorFormat format) {
  const std::string head =
      report::paint("error[" + error.code() + "]", report::Tone::kBad,
                    report::colour_of(STDERR_FILENO));
  std::cerr << head << ": "
            << report::printable(error.place() + ": " + error.problem())
            << "\n  help: " << report::printable(error.remedy()) << std::endl;
  if (format == ErrorFormat::kJson) {
    std::cout << error_document(error) << std::flush;
  }
}

}  // namespace clevis::app
