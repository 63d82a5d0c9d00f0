#include "app/start/init_command.h"

#include <algorithm>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/start/new_folder.h"
#include "app/start/templates.h"
#include "report/text/atomic_file.h"

namespace clevis::app {
namespace {

/// The scene of a template names the schema beside it.
std::string with_schema(std::string_view text) {
  constexpr std::string_view kSchemaLine = "#:schema ./scene.schema.json\n";
  return (text.starts_with(kSchemaLine) ? "" : std::string(kSchemaLine)) +
         std::string(text);
}

}  // namespace

ExitCode init_command(const InitOptions& options) {
  require_new_folder(options.folder);
  const auto chosen =
      std::ranges::find(templates(), options.template_word, &Template::word);
  for (const TemplateFile& file : chosen->files) {
    const bool is_scene = file.name.ends_with(".toml");
    report::write_file(
        options.folder / file.name,
        is_scene ? with_schema(file.text) : std::string(file.text));
  }
  report::write_file(options.folder / "scene.schema.json", scene_schema());
  const std::string scene = (options.folder / "scene.toml").string();
  std::cout << fmt::format("{}: {}\nNext:\n  clevis check --mesh --report {}\n",
                           options.folder.string(), chosen->about, scene);
  return ExitCode::kPass;
}

Run declare_init(CLI::App& command) {
  std::vector<std::string> words;
  std::string about = "Templates:";
  for (const Template& entry : templates()) {
    words.emplace_back(entry.word);
    about += fmt::format("\n  {:<13} {}", entry.word, entry.about);
  }
  command.footer(about);
  const auto options = std::make_shared<InitOptions>();
  command.add_option("NAME", options->folder, "folder to make")->required();
  command
      .add_option("--template", options->template_word,
                  fmt::format("{} [part]", fmt::join(words, ", ")))
      ->type_name("TEMPLATE")
      ->check(CLI::IsMember(words));
  return [options] {
    return init_command(*options);
  };
}

}  // namespace clevis::app
