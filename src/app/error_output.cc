#include "app/error_output.h"

#include <cstdlib>
#include <iostream>
#include <string>

#include <nlohmann/json.hpp>
#include <unistd.h>

namespace clevis::app {
namespace {

bool stderr_takes_colour() {
  const char* const refused = std::getenv("NO_COLOR");
  return isatty(STDERR_FILENO) != 0 && (refused == nullptr || !*refused);
}

/// Names come from the user's files and must not steer the terminal.
std::string printable(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  }
  return text;
}

}  // namespace

void print_error(const Error& error, ErrorFormat format) {
  const bool colour = stderr_takes_colour();
  std::cerr << (colour ? "\033[1;31m" : "") << "error[" << error.code() << "]"
            << (colour ? "\033[0m" : "") << ": "
            << printable(error.place() + ": " + error.problem())
            << "\n  help: " << printable(error.remedy()) << std::endl;
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
