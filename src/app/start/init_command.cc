#include "app/start/init_command.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/request/shell_word.h"
#include "app/start/geometry_scene.h"
#include "app/start/new_folder.h"
#include "app/start/templates.h"
#include "base/messages/errors.h"
#include "part/solid_source.h"

namespace clevis::app {
namespace {

namespace fs = std::filesystem;

std::string content_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

ExitCode init_template(const InitOptions& options) {
  NewScene files(options.folder);
  const auto chosen =
      std::ranges::find(templates(), options.template_word, &Template::word);
  for (const TemplateFile& file : chosen->files) {
    if (file.name == "scene.toml") {
      files.write_scene(file.text);
    } else {
      files.write(std::string(file.name), file.text);
    }
  }
  std::cout << fmt::format("{}: {}\nNext:\n  clevis check --mesh --report {}\n",
                           options.folder.string(), chosen->about,
                           shell_word(files.scene().string()));
  return ExitCode::kPass;
}

ExitCode init_geometry(const InitOptions& options) {
  NewScene files(options.folder);
  const GeometryScene made = geometry_scene(options.geometry);
  files.write(made.file, content_of(options.geometry));
  files.write_scene(made.text);
  files.require_readable(options.geometry);
  std::cout << fmt::format(
      "{0}: {1}\nNext:\n  clevis faces {2} --picture {3}\n"
      "  clevis check --report {2}\n",
      options.folder.string(), made.told, shell_word(files.scene().string()),
      shell_word((options.folder / "faces.svg").string()));
  return ExitCode::kPass;
}

}  // namespace

ExitCode init_command(const InitOptions& options) {
  if (!options.geometry.empty()) return init_geometry(options);
  if (!part::is_solid_file(options.folder)) return init_template(options);
  throw Error("U001", "NAME",
              options.folder.string() + " is a CAD file by its name",
              "Make a scene of it: clevis init NAME --geometry " +
                  shell_word(options.folder.string()) + ".");
}

Run declare_init(CLI::App& command) {
  std::vector<std::string> words;
  std::string about = "Templates:";
  for (const Template& entry : templates()) {
    words.emplace_back(entry.word);
    about += fmt::format("\n  {:<13} {}", entry.word, entry.about);
  }
  about +=
      "\nWith --geometry the scene holds your part by one bore and pulls it by "
      "another; of\na part with one bore or none a plane face holds. The force "
      "stands for yours.";
  command.footer(about);
  const auto options = std::make_shared<InitOptions>();
  command.add_option("NAME", options->folder, "folder to make")->required();
  CLI::Option* word =
      command
          .add_option("--template", options->template_word,
                      fmt::format("{} [part]", fmt::join(words, ", ")))
          ->type_name("TEMPLATE")
          ->check(CLI::IsMember(words));
  command
      .add_option("--geometry", options->geometry,
                  "a part of your own instead: a .step, .stp, .iges, .igs or "
                  ".brep file, copied beside its scene")
      ->type_name("FILE")
      ->excludes(word);
  return [options] {
    return init_command(*options);
  };
}

}  // namespace clevis::app
