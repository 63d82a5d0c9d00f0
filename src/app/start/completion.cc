#include "app/start/completion.h"

#include <iostream>
#include <memory>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace clevis::app {
namespace {

std::vector<std::string> long_options(const CLI::App& command) {
  std::vector<std::string> result;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      result.push_back("--" + name);
    }
  }
  return result;
}

/// A text in single quotes of a shell.
std::string in_quotes(std::string_view text) {
  std::string result = "'";
  for (const char c : text) {
    result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return result + "'";
}

std::string bash(const CLI::App& app) {
  std::vector<std::string> names;
  std::string cases;
  for (const CLI::App* command : app.get_subcommands({})) {
    names.push_back(command->get_name());
    cases += fmt::format(
        "    {}) words={} ;;\n", command->get_name(),
        in_quotes(fmt::format("{}", fmt::join(long_options(*command), " "))));
  }
  return fmt::format(
      R"(_clevis() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} words=
  if [ "$COMP_CWORD" -eq 1 ]; then
    COMPREPLY=($(compgen -W {} -- "$current"))
    return
  fi
  case ${{COMP_WORDS[1]}} in
{}  esac
  if [[ $current == -* ]]; then
    COMPREPLY=($(compgen -W "$words" -- "$current"))
  else
    COMPREPLY=($(compgen -f -- "$current"))
  fi
}}
complete -o filenames -F _clevis clevis
)",
      in_quotes(fmt::format("{} --help --version", fmt::join(names, " "))),
      cases);
}

std::string zsh(const CLI::App& app) {
  return "#compdef clevis\nautoload -U +X bashcompinit && bashcompinit\n" +
         bash(app);
}

std::string fish(const CLI::App& app) {
  std::string result;
  for (const CLI::App* command : app.get_subcommands({})) {
    const std::string& name = command->get_name();
    result += fmt::format(
        "complete -c clevis -n __fish_use_subcommand -a {} "
        "-d {}\n",
        name, in_quotes(command->get_description()));
    for (const CLI::Option* option : command->get_options()) {
      for (const std::string& word : option->get_lnames()) {
        result += fmt::format(
            "complete -c clevis -n '__fish_seen_subcommand_from {}' -l {}{} -d "
            "{}\n",
            name, word, option->get_type_size() > 0 ? " -r" : "",
            in_quotes(option->get_description()));
      }
    }
  }
  return result;
}

}  // namespace

std::string completion(const CLI::App& app, std::string_view shell) {
  if (shell == "bash") return bash(app);
  return shell == "zsh" ? zsh(app) : fish(app);
}

Run declare_completion(CLI::App& command) {
  command.footer(
      "bash: clevis completion bash > ~/.local/share/bash-completion/"
      "completions/clevis\n"
      "zsh:  clevis completion zsh > DIR/_clevis, DIR a folder of $fpath\n"
      "fish: clevis completion fish > ~/.config/fish/completions/clevis.fish");
  const auto shell = std::make_shared<std::string>();
  command.add_option("SHELL", *shell, "bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  return [shell, app = command.get_parent()] {
    std::cout << completion(*app, *shell);
    return ExitCode::kPass;
  };
}

}  // namespace clevis::app
