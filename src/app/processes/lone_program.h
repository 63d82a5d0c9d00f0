#pragma once

#include <filesystem>
#include <string>

namespace clevis::app {

/// File that `name` stands for, sought in the folders of PATH as a shell does;
/// empty: there is none that may be run.
std::filesystem::path find_program(const std::string& name);

/// A program, not a script that starts one.
bool is_binary(const std::filesystem::path& program);

/// From now on this process may become the program at this very pointer, and
/// that program no other, nor may its children (Linux: seccomp). Without effect
/// where the kernel refuses. To be called between fork and exec.
void allow_only(const char* program) noexcept;

}  // namespace clevis::app
