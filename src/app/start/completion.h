#pragma once

#include <string>
#include <string_view>

#include "app/request/command_options.h"

namespace clevis::app {

/// Script that completes commands, options and their words in a shell.
/// @param shell  "bash", "zsh" or "fish".
std::string completion(const CLI::App& app, std::string_view shell);

/// Declares the options of `clevis completion`. @return what runs it.
Run declare_completion(CLI::App& command);

}  // namespace clevis::app
