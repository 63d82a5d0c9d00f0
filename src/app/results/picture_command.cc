#include "app/results/picture_command.h"

#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>

#include "report/page/result_folder.h"
#include "report/picture/mechanism_picture.h"
#include "report/picture/part_picture.h"
#include "report/text/atomic_file.h"

namespace clevis::app {

ExitCode picture_command(const PictureOptions& options) {
  const auto page =
      report::read_result_folder(options.result, report::ResultKind::kCheck);
  const auto file =
      options.file.empty()
          ? options.result /
                (options.part.empty() ? "mechanism.svg" : options.part + ".svg")
          : options.file;
  report::write_file(file,
                     options.part.empty()
                         ? report::mechanism_picture(page)
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
                  "the file [RESULT_DIR/mechanism.svg or NAME.svg]")
      ->type_name("FILE");
  return [options] {
    return picture_command(*options);
  };
}

}  // namespace clevis::app
