#include "app/error_output.h"

#include <iostream>
#include <string>

#include <nlohmann/json.hpp>
#include <unistd.h>

#include "report/text/terminal.h"

namespace clevis::app {

void print_error(const Error& error, ErrorFormat format) {
  const std::string head =
      report::paint("error[" + error.code() + "]", report::Tone::kBad,
                    report::colour_of(STDERR_FILENO));
  std::cerr << head << ": "
            << report::printable(error.place() + ": " + error.problem())
            << "\n  help: " << report::printable(error.remedy()) << std::endl;
  if (format == ErrorFormat::kText) return;
  const nlohmann::ordered_json document = {
      {"schema", 1},
      {"error",
       {{"code", error.code()},
        {"place", error.place()},
        {"problem", error.problem()},
        {"remedy", error.remedy()},
        {"exit_code", static_cast<int>(error.exit_code())}}}};
  constexpr int kIndent = 2;
  // A file name may hold bytes that are no UTF-8: replace, never throw.
  std::cout << document.dump(kIndent, ' ', false,
                             nlohmann::json::error_handler_t::replace)
            << std::endl;
}

}  // namespace clevis::app
