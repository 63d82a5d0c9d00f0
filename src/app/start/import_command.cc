#include "app/start/import_command.h"

#include <iostream>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/companions/model_importer.h"
#include "app/start/new_folder.h"
#include "multibody/scene_text.h"

namespace clevis::app {

ExitCode import_command(const ImportOptions& options) {
  const std::filesystem::path folder =
      options.out.empty() ? options.file.stem() : options.out;
  NewScene files(folder);
  const multibody::SceneText made =
      multibody::scene_text(run_importer(options.file), options.file.string());
  files.write_scene(made.text);
  files.require_readable(options.file);  // what only clevis asks of a scene
  const std::filesystem::path scene = files.scene();
  std::cout << fmt::format("{}: {} bodies, {} joints, {} forces\n",
                           scene.string(), made.bodies, made.joints,
                           made.forces);
  if (!made.told.empty()) std::cout << "lost or assumed:\n";
  for (const std::string& line : made.told) std::cout << "  " << line << '\n';
  std::cout << fmt::format("Next:\n  clevis simulate {}\n", scene.string());
  return ExitCode::kPass;
}

Run declare_import(CLI::App& command) {
  command.footer(
      "Links become bodies, joints joints, their limits stops, springs, "
      "damping\nand friction forces. The file is only read: nothing that it "
      "names is opened\nor run.");
  const auto options = std::make_shared<ImportOptions>();
  command.add_option("FILE", options->file, "an .sdf or .urdf file")
      ->required();
  command
      .add_option("--out", options->out,
                  "folder to make [the file's name without extension]")
      ->type_name("DIR");
  return [options] {
    return import_command(*options);
  };
}

}  // namespace clevis::app
