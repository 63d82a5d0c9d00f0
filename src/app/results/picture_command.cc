#include "app/results/picture_command.h"

#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/messages/errors.h"
#include "report/page/result_folder.h"
#include "report/picture/mechanism_picture.h"
#include "report/picture/part_picture.h"
#include "report/text/atomic_file.h"

namespace clevis::app {

namespace {

namespace fs = std::filesystem;
using report::ResultKind;

/// Other endings would promise formats that this is not.
void require_svg(const fs::path& file) {
  if (file.extension() == ".svg") return;
  throw Error("U001", "--out",
              fmt::format("\"{}\" does not end in .svg", file.string()),
              fmt::format("Pictures are SVG: name it {}.",
                          fs::path(file).replace_extension(".svg").string()));
}

void refuse_simulation(const fs::path& folder) {
  if (report::result_kind(folder) == ResultKind::kCheck) return;
  throw Error(
      "I008", folder.string(),
      "it holds a simulation, which has no meshes to draw",
      fmt::format("Give the folder of a `clevis check`, or see this one "
                  "moving by `clevis report {}`.",
                  folder.string()));
}

std::string picture_of_mechanism(const report::StoredPage& page,
                                 const fs::path& folder) {
  const auto picture = report::mechanism_picture(page);
  if (picture) return *picture;
  const auto parts = report::part_names(page);
  throw Error("I008", folder.string(), "no part of this check moves",
              parts.empty() ? "Give the folder of a check with parts."
                            : fmt::format("Name a part: --part {}.",
                                          fmt::join(parts, " or ")));
}

}  // namespace

ExitCode picture_command(const PictureOptions& options) {
  if (!options.file.empty()) require_svg(options.file);
  refuse_simulation(options.result);
  const auto page =
      report::read_result_folder(options.result, ResultKind::kCheck);
  const auto file =
      options.file.empty()
          ? options.result /
                (options.part.empty() ? "mechanism.svg" : options.part + ".svg")
          : options.file;
  report::write_file(file,
                     options.part.empty()
                         ? picture_of_mechanism(page, options.result)
                         : report::stored_part_picture(page, options.part));
  std::cout << file.string() << "\n";
  return ExitCode::kPass;
}

Run declare_picture(CLI::App& command) {
  command.footer(
      "Draws what `clevis check` wrote: the mechanism at its first, middle and "
      "last\ninstant, or with --part one part at its worst, as `check` does "
      "for "
      "each.");
  const auto options = std::make_shared<PictureOptions>();
  command.add_option("RESULT_DIR", options->result, "folder of the result")
      ->required();
  command.add_option("--part", options->part, "this part, not the mechanism")
      ->type_name("NAME");
  command
      .add_option("--out", options->file,
                  "the file, *.svg [RESULT_DIR/mechanism.svg or NAME.svg]")
      ->type_name("FILE");
  return [options] {
    return picture_command(*options);
  };
}

}  // namespace clevis::app
