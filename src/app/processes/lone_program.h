#pragma once

#include <filesystem>
#include <string>

namespace clevis::app {

/// File that `name` stands for, sought in the folders of PATH as a shell does;
/// empty: there is none that may be run.
std::filesystem::path find_program(const std::string& name);

/// A program, not a script that starts one.
bool is_binary(const std::filesystem::path& program);

}  // namespace clevis::app
