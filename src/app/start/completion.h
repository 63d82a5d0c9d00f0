#pragma once

#include <string>
#include <string_view>

namespace CLI {
class App;
}

namespace clevis::app {

/// Script that completes commands, options and their words in a shell.
/// @param shell  "bash", "zsh" or "fish".
std::string completion(const CLI::App& app, std::string_view shell);

}  // namespace clevis::app
