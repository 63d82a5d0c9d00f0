#include "app/commands/explain_command.h"

#include <algorithm>
#include <cctype>
#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/messages/diagnostics.h"
#include "base/messages/errors.h"

namespace clevis::app {
namespace {

void print_wrapped(std::string_view text) {
  constexpr std::size_t kWidth = 76;
  while (!text.empty()) {
    std::size_t end = text.size();
    if (end > kWidth) end = text.rfind(' ', kWidth);
    std::cout << "  " << text.substr(0, end) << "\n";
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

}  // namespace

ExitCode explain_command(const std::string& code) {
  if (code.empty()) {
    for (const Diagnostic& entry : diagnostics()) {
      std::cout << fmt::format("{}  exit {:2}  {}\n", entry.code,
                               static_cast<int>(entry.exit_code), entry.title);
    }
    return ExitCode::kPass;
  }
  std::string upper = code;
  std::ranges::transform(upper, upper.begin(), [](unsigned char c) {
    return static_cast<char>(std::toupper(c));
  });
  const Diagnostic& entry = find_diagnostic(upper);
  if (entry.code != upper) {
    throw Error("U002", "explain", "there is no diagnostic \"" + code + "\"",
                "`clevis explain` lists all codes.");
  }
  std::cout << fmt::format("{}: {} (exit code {})\n\n", entry.code, entry.title,
                           static_cast<int>(entry.exit_code));
  print_wrapped(entry.explanation);
  return ExitCode::kPass;
}

Run declare_explain(CLI::App& command) {
  const auto code = std::make_shared<std::string>();
  command.add_option("CODE", *code, "e.g. S004; none lists all");
  return [code] {
    return explain_command(*code);
  };
}

}  // namespace clevis::app
