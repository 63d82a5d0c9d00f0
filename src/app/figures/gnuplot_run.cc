#include "app/figures/gnuplot_run.h"

#include <chrono>
#include <fstream>
#include <iostream>
#include <iterator>
#include <optional>

#include <fmt/format.h>

#include "app/processes/child_process.h"
#include "app/processes/temporary_folder.h"
#include "report/text/atomic_file.h"
#include "report/text/terminal.h"

namespace clevis::app {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds kTimeout(30);
constexpr std::size_t kMemory = std::size_t{1} << 30;  // [byte]

std::string read_text(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// What gnuplot made of a script, or why it made nothing.
struct Drawn {
  std::string svg, failure;
};

Drawn drawn(const fs::path& script, const std::string& name) {
  const TemporaryFolder folder;
  const fs::path log = folder.path() / "gnuplot.log";
  const ChildOutcome outcome =
      run_child({.arguments = {"gnuplot", "-d", fs::absolute(script).string()},
                 .folder = folder.path(),
                 .log = log,
                 .memory = kMemory},
                kTimeout);
  if (!outcome.was_found()) {
    return {{}, "gnuplot is not installed (Debian: apt install gnuplot-nox)"};
  }
  if (!outcome.status) {
    return {
        {},
        fmt::format("gnuplot did not finish within {} s", kTimeout.count())};
  }
  Drawn result{read_text(folder.path() / (name + ".svg")), {}};
  // A picture that ends early would still look like one.
  if (!outcome.succeeded() || !result.svg.ends_with("</svg>\n\n")) {
    constexpr std::size_t kLongest = 300;
    result.failure = "gnuplot failed: " + read_text(log).substr(0, kLongest);
  }
  return result;
}

}  // namespace

void draw_figures(const std::vector<NamedFigure>& figures,
                  const fs::path& folder) {
  std::string failure;
  for (const auto& [name, figure] : figures) {
    const fs::path script = folder / (name + ".gp");
    const fs::path picture = folder / (name + ".svg");
    report::write_file(script, report::gnuplot_script(figure, name));
    const Drawn result = drawn(script, name);
    if (result.failure.empty()) {
      report::write_file(picture, result.svg);
      continue;
    }
    std::error_code ignored;
    fs::remove(picture, ignored);  // of other data
    if (result.failure == failure) continue;
    failure = result.failure;
    std::cerr << report::printable(
                     fmt::format("{} is not drawn: {}. `gnuplot {}.gp` in that "
                                 "folder draws it.",
                                 picture.string(), failure, name))
              << std::endl;
  }
}

}  // namespace clevis::app
