#include "app/start/import_command.h"

#include <iostream>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/companions/model_importer.h"
#include "app/start/new_folder.h"
#include "app/start/templates.h"
#include "multibody/scene_text.h"
#include "report/text/atomic_file.h"
#include "scene/scene.h"

namespace clevis::app {

ExitCode import_command(const ImportOptions& options) {
  const std::filesystem::path folder =
      options.out.empty() ? options.file.stem() : options.out;
  require_new_folder(folder);
  const multibody::SceneText made =
      multibody::scene_text(run_importer(options.file), options.file.string());
  const std::filesystem::path scene = folder / "scene.toml";
  report::write_file(scene, "#:schema ./scene.schema.json\n" + made.text);
  report::write_file(folder / "scene.schema.json", scene_schema());
  std::cout << fmt::format("{}: {} bodies, {} joints, {} forces\n",
                           scene.string(), made.bodies, made.joints,
                           made.forces);
  if (!made.told.empty()) std::cout << "lost or assumed:\n";
  for (const std::string& line : made.told) std::cout << "  " << line << '\n';
  scene::read_scene(scene);  // refuses what only clevis asks of a scene
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
