#include "app/start/import_command.h"

#include <iostream>
#include <memory>
#include <string>
#include <system_error>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/companions/model_importer.h"
#include "app/start/new_folder.h"
#include "app/start/templates.h"
#include "multibody/scene_text.h"
#include "report/text/atomic_file.h"
#include "scene/scene.h"

namespace clevis::app {

namespace {

namespace fs = std::filesystem;

/// The files of a new scene, and its folder if that is new too.
class NewScene {
 public:
  explicit NewScene(fs::path folder)
      : folder_(std::move(folder)), is_made_(!fs::exists(folder_)) {}

  fs::path scene() const { return folder_ / "scene.toml"; }

  void write(const std::string& text) const {
    report::write_file(scene(), "#:schema ./scene.schema.json\n" + text);
    report::write_file(schema(), scene_schema());
  }

  void remove() const {
    std::error_code ignored;
    fs::remove(scene(), ignored);
    fs::remove(schema(), ignored);
    if (is_made_) fs::remove(folder_, ignored);
  }

 private:
  fs::path schema() const { return folder_ / "scene.schema.json"; }

  fs::path folder_;
  bool is_made_;
};

}  // namespace

ExitCode import_command(const ImportOptions& options) {
  const std::filesystem::path folder =
      options.out.empty() ? options.file.stem() : options.out;
  require_new_folder(folder);
  const multibody::SceneText made =
      multibody::scene_text(run_importer(options.file), options.file.string());
  const NewScene files(folder);
  files.write(made.text);
  const fs::path scene = files.scene();
  try {
    scene::read_scene(scene);  // refuses what only clevis asks of a scene
  } catch (...) {
    files.remove();
    throw;
  }
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
