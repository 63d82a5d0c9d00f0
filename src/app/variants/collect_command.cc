#include "app/variants/collect_command.h"

#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>
#include <unistd.h>

#include "app/figures/gnuplot_run.h"
#include "report/text/atomic_file.h"
#include "report/variants/collection_csv.h"
#include "report/variants/collection_figure.h"
#include "report/variants/collection_table.h"
#include "report/variants/variant_reader.h"

namespace clevis::app {

ExitCode collect_command(const std::filesystem::path& folder) {
  const report::Collection collection = report::read_collection(folder);
  report::write_file(folder / "variants.csv",
                     report::collection_csv(collection));
  draw_figures({{"variants", report::collection_figure(collection)}}, folder);
  std::cout << report::collection_table(collection,
                                        report::colour_of(STDOUT_FILENO))
            << "\nfiles: " << (folder / "variants.csv").string();
  for (const char* name : {"variants.gp", "variants.svg"}) {
    if (std::filesystem::exists(folder / name)) {
      std::cout << ", " << (folder / name).string();
    }
  }
  std::cout << "\n";
  return report::exit_code(collection);
}

Run declare_collect(CLI::App& command) {
  const auto folder = std::make_shared<std::filesystem::path>();
  command.add_option("DIR", *folder, "folder that the plan was written to")
      ->required();
  return [folder] {
    return collect_command(*folder);
  };
}

}  // namespace clevis::app
